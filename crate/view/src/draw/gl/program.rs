//! Shader programs.

use glam::{Mat4, Vec2, Vec3, Vec4};
use web_sys::{WebGlProgram, WebGlShader, WebGlUniformLocation};

use super::{Gl, GlError};

/// A linked program and the places of its uniforms.
#[derive(Debug)]
pub struct Program {
    program: WebGlProgram,
    uniforms: Vec<(&'static str, Option<WebGlUniformLocation>)>,
}

impl Program {
    /// Compiles and links. The sources are without their `#version` line; `defines` go before both.
    /// The names of all uniforms are given once, so that drawing never asks the driver for them.
    ///
    /// # Errors
    /// [`GlError`] if the driver refuses a shader or gives no object.
    pub fn new(
        gl: &Gl,
        defines: &str,
        vertex: &str,
        fragment: &str,
        uniforms: &[&'static str],
    ) -> Result<Self, GlError> {
        let program = gl.create_program().ok_or(GlError::Lost)?;
        for (kind, source) in [(Gl::VERTEX_SHADER, vertex), (Gl::FRAGMENT_SHADER, fragment)] {
            let shader = compile(gl, kind, defines, source)?;
            gl.attach_shader(&program, &shader);
            // Lives on for as long as the program needs it.
            gl.delete_shader(Some(&shader));
        }
        gl.link_program(&program);
        let linked = gl.get_program_parameter(&program, Gl::LINK_STATUS);
        if linked.as_bool() != Some(true) {
            if gl.is_context_lost() {
                return Err(GlError::Lost);
            }
            return Err(GlError::Shader(
                gl.get_program_info_log(&program).unwrap_or_default(),
            ));
        }
        let uniforms = uniforms
            .iter()
            .map(|&name| (name, gl.get_uniform_location(&program, name)))
            .collect();
        Ok(Self { program, uniforms })
    }

    /// Makes it the one that draws.
    pub fn activate(&self, gl: &Gl) {
        gl.use_program(Some(&self.program));
    }

    fn place(&self, name: &str) -> Option<&WebGlUniformLocation> {
        let found = self.uniforms.iter().find(|(known, _)| *known == name);
        debug_assert!(found.is_some(), "uniform {name} was not declared");
        found.and_then(|(_, place)| place.as_ref())
    }

    /// Sets an integer or the number of a texture unit.
    pub fn set_i32(&self, gl: &Gl, name: &str, value: i32) {
        gl.uniform1i(self.place(name), value);
    }

    /// Sets a number.
    pub fn set_f32(&self, gl: &Gl, name: &str, value: f32) {
        gl.uniform1f(self.place(name), value);
    }

    /// Sets a pair of numbers.
    pub fn set_vec2(&self, gl: &Gl, name: &str, value: Vec2) {
        gl.uniform2f(self.place(name), value.x, value.y);
    }

    /// Sets three numbers.
    pub fn set_vec3(&self, gl: &Gl, name: &str, value: Vec3) {
        gl.uniform3f(self.place(name), value.x, value.y, value.z);
    }

    /// Sets four numbers.
    pub fn set_vec4(&self, gl: &Gl, name: &str, value: Vec4) {
        gl.uniform4f(self.place(name), value.x, value.y, value.z, value.w);
    }

    /// Sets four integers.
    pub fn set_ivec4(&self, gl: &Gl, name: &str, [x, y, z, w]: [i32; 4]) {
        gl.uniform4i(self.place(name), x, y, z, w);
    }

    /// Sets a matrix.
    pub fn set_mat4(&self, gl: &Gl, name: &str, value: &Mat4) {
        gl.uniform_matrix4fv_with_f32_array(self.place(name), false, &value.to_cols_array());
    }
}

fn compile(gl: &Gl, kind: u32, defines: &str, source: &str) -> Result<WebGlShader, GlError> {
    let shader = gl.create_shader(kind).ok_or(GlError::Lost)?;
    let precision = "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
    gl.shader_source(
        &shader,
        &format!("#version 300 es\n{defines}{precision}{source}"),
    );
    gl.compile_shader(&shader);
    let compiled = gl.get_shader_parameter(&shader, Gl::COMPILE_STATUS);
    if compiled.as_bool() == Some(true) {
        return Ok(shader);
    }
    if gl.is_context_lost() {
        return Err(GlError::Lost);
    }
    Err(GlError::Shader(
        gl.get_shader_info_log(&shader).unwrap_or_default(),
    ))
}
