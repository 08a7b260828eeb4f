/* legacygl: OpenGL 1.1's fixed-function pipeline with display lists on OpenGL ES 3 / WebGL 2.

   Everything a program draws with is declared by the platform's own <GL/gl.h> and <GL/glu.h>; this
   header adds what those lack: making a context. It is C.

   What is implemented so far, and what is not, is listed at the end of this header. */
#ifndef LEGACYGL_H
#define LEGACYGL_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A context: all of OpenGL 1.1's state, its lists and textures. Used from one thread. */
typedef struct LegacyGLContext LegacyGLContext;

/** Finds an OpenGL ES 3 function by its name ("glDrawArrays"), as eglGetProcAddress does. */
typedef void* (*LegacyGLLoader)(const char* name);

/** Where a context draws. */
typedef enum LegacyGLTarget
{
    /** Straight into the window's default framebuffer; nothing is kept after a present. */
    LEGACYGL_TARGET_WINDOW = 0,
    /** Into front and back colours, depth and stencil of its own that keep their contents; present makes
        the back the front and shows it, and the back keeps its contents too. */
    LEGACYGL_TARGET_OWN = 1,
    /** The same with one colour buffer, which is the front: a single-buffered window. */
    LEGACYGL_TARGET_OWN_SINGLE = 2
} LegacyGLTarget;

/** Makes a context for the OpenGL ES 3 / WebGL 2 context that is current, and makes it current.
    loader: finds the ES functions; NULL on the web, where they are linked.
    width, height: the target's size in pixels, at least 1.
    Returns NULL when the size is not positive or a required function is missing; legacygl_last_message()
    then says which. The ES context must stay current while this context is used, and its state belongs
    to legacygl from then on. */
LegacyGLContext* legacygl_create(LegacyGLLoader loader, int width, int height, LegacyGLTarget target);

/** Frees the context, its lists, textures and ES objects. NULL is allowed. */
void legacygl_destroy(LegacyGLContext* context);

/** Makes the context the one that gl* calls go to; NULL: none, and gl* calls then do nothing. */
void legacygl_make_current(LegacyGLContext* context);

/** Returns the context that gl* calls go to, or NULL. */
LegacyGLContext* legacygl_current(void);

/** Tells the target's new size in pixels (at least 1). An own target keeps what fits; the viewport is
    not changed, as a window system does not change it either. */
void legacygl_resize(LegacyGLContext* context, int width, int height);

/** Finishes the frame: draws what is pending and, from an own target, copies the back into the front and
    that into the default framebuffer. Swapping the window's buffers stays the caller's. */
void legacygl_present(LegacyGLContext* context);

/** Copies the front of an own target into the default framebuffer and leaves the back alone: for what a
    program draws into the front, after its glFlush. */
void legacygl_show_front(LegacyGLContext* context);

/** Tells that the ES context is lost: its objects are forgotten, calls go on recording state. */
void legacygl_context_lost(LegacyGLContext* context);

/** Tells that the ES context is back (and current): lists and textures are built again when next used.
    What an own target showed is gone. */
void legacygl_context_restored(LegacyGLContext* context);

/** Returns what the last failed legacygl_* call complained about, or "". */
const char* legacygl_last_message(void);

/** Counts since the last legacygl_reset_counters. */
typedef struct LegacyGLCounters
{
    uint64_t draw_calls;      /**< ES draw calls. */
    uint64_t vertices;        /**< Vertices (or indices) those draw calls named. */
    uint64_t programs;        /**< Shader programs linked. */
    uint64_t uploads;         /**< Buffer and texture uploads. */
    uint64_t upload_bytes;    /**< Bytes in those. */
    uint64_t uniform_uploads; /**< Uniform calls. */
} LegacyGLCounters;

/** Returns the context's counters. */
LegacyGLCounters legacygl_counters(const LegacyGLContext* context);

/** Sets all counters to zero. */
void legacygl_reset_counters(LegacyGLContext* context);

/** One captured call. */
typedef struct LegacyGLCall
{
    const char* name;   /**< "glTranslatef"; static. */
    int list_depth;     /**< 0: the program called it; n: it ran inside n nested lists. */
    int argument_count; /**< How many of arguments are set; a pointer's pointees count where short (matrices).
                         */
    double arguments[16]; /**< The arguments as numbers, in order. */
    float modelview[16];  /**< The modelview matrix on top when the call was made, column-major. */
} LegacyGLCall;

/** Begins noting every gl* call, also those that lists make; what was noted before is dropped. */
void legacygl_capture_begin(LegacyGLContext* context);

/** Ends noting. Returns the calls, valid until the next capture begins or the context is destroyed. */
const LegacyGLCall* legacygl_capture_end(LegacyGLContext* context, size_t* count);

/* What is implemented so far, and how it differs from OpenGL
   ============================================================

   Implemented, with all their type variants: glBegin, glEnd, glVertex, glNormal, glColor, glTexCoord,
   glMultiTexCoord, glSecondaryColor, glFogCoord, glIndex, glRect; glMatrixMode, glLoadIdentity, glLoadMatrix,
   glMultMatrix, glLoadTransposeMatrix, glMultTransposeMatrix, glTranslate, glRotate, glScale, glFrustum,
   glOrtho, glPushMatrix, glPopMatrix, glViewport, glDepthRange; glGenLists, glNewList, glEndList, glCallList,
   glCallLists, glListBase, glDeleteLists, glIsList; glLight, glLightModel, glMaterial, glColorMaterial,
   glShadeModel; glGenTextures, glBindTexture, glDeleteTextures, glIsTexture, glPrioritizeTextures,
   glAreTexturesResident, glTexImage1D, glTexImage2D (proxies too), glTexSubImage1D, glTexSubImage2D,
   glCopyTexImage1D, glCopyTexImage2D, glCopyTexSubImage1D, glCopyTexSubImage2D, glGetTexImage,
   glTexParameter, glTexEnv, glTexGen, glActiveTexture; glEnable, glDisable, glIsEnabled, glCullFace,
   glFrontFace, glLineWidth, glLineStipple, glPointSize, glPointParameter, glProvokingVertex, glPolygonMode,
   glPolygonStipple, glPolygonOffset, glEdgeFlag, glClipPlane, glGetClipPlane, glGetPolygonStipple, glLogicOp,
   glDepthFunc, glDepthMask, glAlphaFunc, glScissor, glStencilFunc, glStencilOp, glStencilMask, glBlendFunc,
   glBlendFuncSeparate, glBlendEquation, glBlendEquationSeparate, glBlendColor, glColorMask, glIndexMask,
   glSampleCoverage, glFog; glClear, glClearColor, glClearDepth, glClearStencil, glClearIndex, glClearAccum,
   glDrawBuffer, glReadBuffer, glFlush, glFinish, glReadPixels, glPixelStore; the vertex arrays
   (glVertexPointer … glDrawElements, glInterleavedArrays) and buffer objects; glPushAttrib, glPopAttrib,
   glPushClientAttrib, glPopClientAttrib; glGet, glGetLight, glGetMaterial, glGetTexEnv, glGetTexGen,
   glGetTexParameter, glGetTexLevelParameter, glGetPointerv, glGetError, glGetString, glHint; and their names
   as extensions, which glGetString(GL_EXTENSIONS) lists. Of GLU: projections, quadrics, mipmaps, glu strings;
   what GLU lacks says so once on stderr when it is called (src/legacygl/glu/unimplemented.cpp names it).

   Not implemented: a call sets GL_INVALID_OPERATION and says so once on stderr: glRasterPos, glBitmap,
   glDrawPixels, glCopyPixels, glPixelZoom, glPixelTransfer, glPixelMap, glGetPixelMap; glRenderMode but for
   GL_RENDER, glSelectBuffer, glFeedbackBuffer, glPassThrough (glInitNames, glLoadName, glPushName and
   glPopName do nothing, as in OpenGL outside selection); glMap, glGetMap, glMapGrid, glEvalCoord, glEvalMesh,
   glEvalPoint; glAccum; images of colour indices; and what
   <GL/gl.h> declares of volumes (glTexImage3D …), of compressed images (glCompressedTexImage2D …) and of the
   imaging subset (glColorTable, glConvolutionFilter2D, glHistogram …).

   Errors are found as OpenGL prescribes. A library built with the CMake option LEGACYGL_UNCHECKED looks for
   none, as a context of GL_KHR_no_error: what a wrong call does is then undefined.

   Differences: GL_POLYGON_SMOOTH has no effect, as in Mesa's software renderer; smooth lines and points have
   a coverage that falls over their last pixel, not an exact one. Edge flags count for all polygons, strips
   and fans too, as in Mesa. A logic op other than GL_COPY reads the target back; what is drawn into front and
   back at once, it combines with the back. Textures are stored with eight bits a channel, or fewer where
   their format says so; a texture's border texels are dropped, and the border's colour stands for them, as
   with Mesa. Texels copied from the frame buffer are read back to the CPU. A window's framebuffer has no
   front of its own: drawing into the front draws into the back. Multisampling and colour indices are state
   that nothing shows. There are no accumulation and no auxiliary buffers, and no stereo. Depths and stencil
   values are read through a copy; a window with antialiasing refuses that with GL_INVALID_OPERATION, an own
   target never does. */

#ifdef __cplusplus
}
#endif
#endif
