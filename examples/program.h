/* What window.c and page.c ask of a program for OpenGL 1.1. */
#ifndef PROGRAM_H
#define PROGRAM_H

enum
{
    WIDTH = 640, /* pixels */
    HEIGHT = 480
};

/** Called once, with the OpenGL context current. */
void set_up(void);

/** Draws what is to be seen so many seconds after the beginning. */
void draw(double seconds);

#endif
