// The list program as one writes it for WebGL 2: a vertex array and a buffer for each cube, one shader, and a
// frame that multiplies a matrix, sets one uniform and draws, for each.

const VERTEX = `#version 300 es
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 color;
uniform mat4 projection_modelview;
out vec3 shade;
void main() {
    gl_Position = projection_modelview * vec4(place, 1.0);
    shade = color;
}`;
const FRAGMENT = `#version 300 es
precision highp float;
in vec3 shade;
out vec4 color;
void main() { color = vec4(shade, 1.0); }`;

const VERTICES = 36;

function multiply(out, a, b, at) {
  for (let column = 0; column < 16; column += 4) {
    const x = b[at + column];
    const y = b[at + column + 1];
    const z = b[at + column + 2];
    const w = b[at + column + 3];
    out[column] = a[0] * x + a[4] * y + a[8] * z + a[12] * w;
    out[column + 1] = a[1] * x + a[5] * y + a[9] * z + a[13] * w;
    out[column + 2] = a[2] * x + a[6] * y + a[10] * z + a[14] * w;
    out[column + 3] = a[3] * x + a[7] * y + a[11] * z + a[15] * w;
  }
}

function makeProgram(gl) {
  const program = gl.createProgram();
  for (const [kind, text] of [
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, FRAGMENT],
  ]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    throw new Error(gl.getProgramInfoLog(program));
  }
  return program;
}

/** Sets up the program: meshes are Float32Arrays of place and colour, matrices 16 numbers for each mesh.
    Gives a function that draws the frame of a number. */
export function webglLists(gl, meshes, matrices) {
  const program = makeProgram(gl);
  gl.useProgram(program);
  const uniform = gl.getUniformLocation(program, "projection_modelview");
  const arrays = meshes.map((mesh) => {
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, mesh, gl.STATIC_DRAW);
    for (const [location, offset] of [
      [0, 0],
      [1, 12],
    ]) {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 24, offset);
    }
    return array;
  });
  gl.enable(gl.DEPTH_TEST);
  gl.clearColor(0.1, 0.1, 0.2, 1);
  const projection = new Float32Array([2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -62 / 58, -1, 0, 0, -240 / 58, 0]);
  const camera = new Float32Array(16);
  const view = new Float32Array(16);
  const combined = new Float32Array(16);
  return (number) => {
    const angle = (number * Math.PI) / 180;
    const s = Math.sin(angle);
    const c = Math.cos(angle);
    view.set([c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, -30, 1]);
    multiply(camera, projection, view, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (let i = 0; i < arrays.length; ++i) {
      multiply(combined, camera, matrices, 16 * i);
      gl.uniformMatrix4fv(uniform, false, combined);
      gl.bindVertexArray(arrays[i]);
      gl.drawArrays(gl.TRIANGLES, 0, VERTICES);
    }
  };
}
