#include "mesh/obj_reader.h"
#include "tests/mesh/invariants.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace {

constexpr const char* corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// Reads a text that must be refused, and returns the message, "test.obj:LINE: CAUSE".
std::string refusal(const std::string& text)
{
    const base::Result<mesh::ObjMesh> result = mesh::read_obj("test.obj", text);
    if (result) {
        return "was read";
    }
    const auto is_line_end = [](char c) { return c == '\n' || c == '\r'; };
    EXPECT_EQ(broken_invariant(result.error(), 1 + int(std::count_if(text.begin(), text.end(), is_line_end))),
              "");
    return result.error().message();
}

/// The same, of one line between a good triangle's vertices (lines 1 to 3) and its face.
std::string refusal_of_line(const std::string& line)
{
    return refusal(corner + line + "\nf 1 2 3\n");
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

// What is wrong with the whole text.

TEST(ReadObjRefuses, NoTextAtAll)
{
    EXPECT_EQ(refusal(""), "test.obj: the file is empty");
    EXPECT_EQ(refusal(" \n\t\r\n"), "test.obj: the file is empty");
}

TEST(ReadObjRefuses, ATextWithoutFaces)
{
    EXPECT_EQ(refusal(corner), "test.obj: the file has vertices but no faces");
    EXPECT_EQ(refusal("<html>not found</html>\n"),
              "test.obj: the file has no vertices and no faces; is it an OBJ file?");
}

TEST(ReadObjRefuses, BinaryData)
{
    EXPECT_TRUE(
        contains(refusal(std::string("v 0 0 0\nv 1\0 2 3\n", 17)), "test.obj:2: there is binary data here"));
    EXPECT_TRUE(
        contains(refusal("\x89PNG\r\n\x1A\n"), "test.obj:2: there is binary data here (a byte of value 26)"));
}

TEST(ReadObjRefuses, Utf16)
{
    EXPECT_TRUE(contains(refusal(std::string("\xFF\xFEv\0 \0", 6)), "UTF-16"));
}

TEST(ReadObjRefuses, AnAbsurdlyLongLine)
{
    EXPECT_TRUE(contains(refusal(corner + std::string(2'000'000, 'x') + "\nf 1 2 3\n"),
                         "test.obj:4: the line is longer"));
}

TEST(ReadObjRefuses, ATextOfAHundredMegabytes)
{
    std::string text;
    text.reserve(100 << 20);
    while (text.size() < (100 << 20)) {
        text += corner;
    }
    EXPECT_EQ(refusal(text),
              "test.obj: the file has 100 MB and at most 32 MB are read; reduce the number of polygons "
              "or split the model");
}

TEST(ReadObjRefuses, TooManyTriangles)
{
    std::string face = "f";
    for (int i = 0; i < 100'000; ++i) {
        face += " 1 2";
    }
    std::string text = corner;
    for (int i = 0; i < 11; ++i) {
        text += face + "\n";
    }
    EXPECT_TRUE(contains(refusal(text), "test.obj:14: the model has more than 2000000 triangles"));
}

// Numbers.

TEST(ReadObjRefuses, AVertexThatIsCutShort)
{
    EXPECT_EQ(refusal_of_line("v 1 2"),
              "test.obj:4: a vertex (v) needs three numbers, and may have a weight or a colour "
              "after them; this line has 2");
    EXPECT_TRUE(contains(refusal_of_line("v"), "this line has 0"));
    EXPECT_TRUE(contains(refusal_of_line("v 1 # 2 3"), "this line has 1"));
}

TEST(ReadObjRefuses, AVertexWithTooManyNumbers)
{
    EXPECT_TRUE(contains(refusal_of_line("v 1 2 3 4 5 6 7 8 9"), "test.obj:4: a vertex (v) needs three"));
}

TEST(ReadObjRefuses, ANormalWithoutThreeNumbers)
{
    EXPECT_EQ(refusal_of_line("vn 1 0"), "test.obj:4: a normal (vn) needs three numbers; this line has 2");
    EXPECT_EQ(refusal_of_line("vn 1 0 0 0"),
              "test.obj:4: a normal (vn) needs three numbers; this line has more");
}

TEST(ReadObjRefuses, ATextureCoordinateWithoutOneToThreeNumbers)
{
    EXPECT_TRUE(contains(refusal_of_line("vt"), "test.obj:4: a texture coordinate (vt) needs one to three"));
    EXPECT_TRUE(contains(refusal_of_line("vt 1 2 3 4"), "this line has more"));
}

TEST(ReadObjRefuses, WhatIsNotANumber)
{
    for (const std::string word : {"x", "-", "+", ".", "-.", "1.2.3", "1.5abc", "1e", "1e+", "e5", "--1",
                                   "0x10", "1-2", "1e5.0", "1/2", "'1'", "1_000", "\xC2\xBD"}) {
        EXPECT_TRUE(contains(refusal_of_line("v 1 " + word + " 2"), "test.obj:4: '")) << word;
    }
}

TEST(ReadObjRefuses, ADecimalCommaAndSaysSo)
{
    EXPECT_EQ(refusal_of_line("vn 0 1,5 0"),
              "test.obj:4: '1,5' is not a number; decimals are written with a point, not with a comma");
}

TEST(ReadObjRefuses, NotANumberAndInfinity)
{
    for (const std::string word :
         {"nan", "NaN", "-nan", "nan(ind)", "-nan(snan)", "inf", "-Inf", "INFINITY", "+inf"}) {
        for (const std::string keyword : {"v 0 0 ", "vn 0 0 ", "vt 0 "}) {
            EXPECT_TRUE(contains(refusal_of_line(keyword + word), "is not a number a model can have"))
                << word;
        }
    }
}

TEST(ReadObjRefuses, ANumberOutsideFloatsRange)
{
    EXPECT_TRUE(contains(refusal_of_line("v 0 0 3.5e38"), "test.obj:4: '3.5e38' is outside the range"));
    EXPECT_TRUE(contains(refusal_of_line("v 0 0 -1e39"), "is outside the range"));
    EXPECT_TRUE(contains(refusal_of_line("v 0 0 1e400"), "is outside the range"));
    EXPECT_TRUE(contains(refusal_of_line("v 0 0 " + std::string(60, '9')), "is outside the range"));
    // These two overflow an int.
    EXPECT_TRUE(contains(refusal_of_line("v 0 0 1e2147483648"), "has an exponent outside the range"));
    EXPECT_TRUE(contains(refusal_of_line("v 0 0 1e-2147483649"), "has an exponent outside the range"));
}

TEST(ReadObjRefuses, AnEndlessNumber)
{
    EXPECT_TRUE(contains(refusal_of_line("v 0 0 " + std::string(1000, '1')), "is too long for a number"));
}

// Faces.

TEST(ReadObjRefuses, AFaceWithFewerThanThreeVertices)
{
    EXPECT_EQ(refusal_of_line("f 1 2"),
              "test.obj:4: a face (f) needs at least three vertices; this one has 2");
    EXPECT_TRUE(contains(refusal_of_line("f"), "this one has 0"));
    EXPECT_TRUE(contains(refusal_of_line("f 1 2 # 3"), "this one has 2"));
}

TEST(ReadObjRefuses, IndexZero)
{
    for (const std::string face :
         {"f 0 1 2", "f 1 2 -0", "f 1 +000 2", "f 1/0 2/1 3/1", "f 1//0 2//1 3//1", "f 1/1/0 2 3"}) {
        EXPECT_TRUE(
            contains(refusal_of_line(face), "has an index 0; indices count from 1, or backwards from -1"))
            << face;
    }
}

TEST(ReadObjRefuses, AnIndexBeyondTheLast)
{
    EXPECT_EQ(refusal_of_line("f 1 2 4"),
              "test.obj:4: vertex index 4 is out of range: 3 were given before this line");
    EXPECT_TRUE(
        contains(refusal_of_line("f 1/1 2/1 3/1"), "texture coordinate index 1 is out of range: 0 were"));
    EXPECT_TRUE(contains(refusal(std::string(corner) + "vn 0 0 1\nf 1//1 2//1 3//2\n"),
                         "test.obj:5: normal index 2 is out of range: 1 was given before this line"));
}

TEST(ReadObjRefuses, AnIndexOfWhatComesOnlyLater)
{
    EXPECT_TRUE(contains(refusal("v 0 0 0\nv 1 0 0\nf 1 2 3\nv 0 1 0\n"),
                         "test.obj:3: vertex index 3 is out of range"));
}

TEST(ReadObjRefuses, ANegativeIndexBeforeTheFirst)
{
    EXPECT_TRUE(contains(refusal_of_line("f -1 -2 -4"), "test.obj:4: vertex index -4 is out of range"));
    EXPECT_TRUE(contains(refusal("f -1 -2 -3\n"), "test.obj:1: vertex index -1 is out of range: 0 were"));
    EXPECT_TRUE(contains(refusal_of_line("f 1//-1 2//-1 3//-1"), "normal index -1 is out of range"));
}

TEST(ReadObjRefuses, AHugeIndex)
{
    for (const std::string index : {"999999999", "-999999999", "2147483648", "-2147483649", "4294967297",
                                    "99999999999999999999999999"}) {
        EXPECT_TRUE(contains(refusal_of_line("f 1 2 " + index), "out of range")) << index;
    }
}

TEST(ReadObjRefuses, ACornerThatIsNoneOfTheFourForms)
{
    for (const std::string word :
         {"x", "1/", "/1", "1//", "//1", "1/2/", "/", "1x", "1.0", "1-2", "+", "-", "1/x", "1\\2"}) {
        EXPECT_TRUE(contains(refusal_of_line("f 1 2 " + word), "is not a corner of a face")) << word;
    }
    EXPECT_TRUE(contains(refusal_of_line("f 1/1/1/1 2 3"), "has more than three indices"));
    EXPECT_TRUE(
        contains(refusal_of_line("f 1 2 " + std::string(1000, '0') + "1"), "is too long for a corner"));
}

TEST(ReadObjRefuses, AFaceThatMixesForms)
{
    const std::string before = std::string(corner) + "vt 0 0\nvn 0 0 1\n";
    for (const std::string face :
         {"f 1 2/1 3", "f 1/1 2 3", "f 1//1 2/1 3/1", "f 1/1/1 2/1 3/1/1", "f 1/1/1 2//1 3/1/1"}) {
        EXPECT_TRUE(contains(refusal(before + face), "test.obj:6: a face must be written the same way"))
            << face;
    }
}

// Where.

TEST(ReadObjRefuses, NamingTheLineOfTheWordInAContinuedStatement)
{
    EXPECT_TRUE(contains(refusal(std::string(corner) + "f 1 \\\n2 \\\r\n9\n"), "test.obj:6: vertex index 9"));
}

TEST(ReadObjRefuses, NamingTheLineOnWhichAStatementBeginsWhenItIsShort)
{
    EXPECT_TRUE(
        contains(refusal(std::string(corner) + "\n\nf \\\n1 \\\n2\n\n"), "test.obj:6: a face (f) needs"));
}

TEST(ReadObjRefuses, CountingEveryKindOfLineEndOnce)
{
    EXPECT_TRUE(
        contains(refusal("v 0 0 0\r\n\r\n# c\rv 1 0 0\n\nv x 0 0"), "test.obj:6: 'x' is not a number"));
}

TEST(ReadObjRefuses, ShorteningAndCleaningWhatItQuotes)
{
    EXPECT_EQ(refusal_of_line("v 0 0 \xFF\x7F<script>" + std::string(80, 'y')),
              "test.obj:4: '\?\?<script>yyyyyyyyyyyyyyyyyyyyyy...' is not a number");
}

} // namespace
