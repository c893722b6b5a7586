//! How the golden subjects are made in C: by the calls that their tokens say, and tables by hand.

use super::bound::Bound;
use super::call::Call;
use microwarp_list::{FACES, VERTICES, weights};

/// How a warp is made in C.
#[derive(Clone)]
pub struct Made<'a> {
    pub warp: &'a Bound,
    /// What stands before the call.
    pub lines: Vec<String>,
    pub init: String,
    pub arguments: String,
}

pub fn made<'a>(call: &Call<'a>) -> Made<'a> {
    let (mut lines, mut arguments) = (Vec::new(), Vec::new());
    for ((parameter, form), value) in call.constructor.parameters.iter().zip(&call.arguments) {
        if form.is_number() {
            arguments.push(value.clone());
        } else {
            let name = format!("given_{parameter}");
            lines.push(format!("static const {} = {value};", form.declared(&name)));
            arguments.push(name);
        }
    }
    let init = match call.constructor.name {
        "new" => "init".to_owned(),
        name => format!("init_{name}"),
    };
    Made {
        warp: call.warp,
        lines,
        init,
        arguments: arguments.join(", "),
    }
}

/// The subjects over tables of 32 bits, whose constructors are not calls with numbers: by hand, as `warps.rs` has them.
pub fn tables(handles: &[Bound]) -> Vec<(&'static str, Made<'_>)> {
    let row = weights().map(|weight| format!("{weight:e}f"));
    let row = row.join(", ").replace("0e0f", "0.0f");
    let one = vec![
        format!("static const float weights[6] = {{{row}}};"),
        "uint32_t entries[6];".into(),
    ];
    let picture = ["0.0f", "0.5f"].map(|same| [same; 6].join(", "));
    let picture = format!(
        "static const float weights[18] = {{{row}, {}}};",
        picture.join(", ")
    );
    let two = vec![picture, "uint32_t marginal[3], conditional[18];".into()];
    let rectangle =
        "static const float u_range[2] = {0.0f, 6.0f}, v_range[2] = {-1.0f, 1.0f};".to_owned();
    let [vertices, faces] = [
        VERTICES.map(|vertex| format!("{{{}}}", vertex.map(|x| format!("{x:?}f")).join(", "))),
        FACES.map(|face| format!("{{{}}}", face.map(|i| i.to_string()).join(", "))),
    ];
    let mesh = vec![
        one[0].clone(),
        "uint32_t entries[6];".into(),
        format!(
            "static const float vertices[6][3] = {{{}}};",
            vertices.join(", ")
        ),
        format!(
            "static const uint16_t faces[6][3] = {{{}}};",
            faces.join(", ")
        ),
        "float of_faces[6];".into(),
        "memcpy(of_faces, areas, sizeof of_faces);".into(),
        "expect_error(out, MW_OK, mw_cdf_build(weights, 6, entries));".into(),
    ];
    let all = [
        (
            "PiecewiseConstant1d",
            "piecewise_constant_1d",
            "build",
            one.clone(),
            "weights, 6, -3.0f, 5.0f, entries",
        ),
        (
            "PiecewiseLinear1d",
            "piecewise_linear_1d",
            "build",
            one,
            "weights, 6, -3.0f, 5.0f, entries",
        ),
        (
            "PiecewiseConstant2d",
            "piecewise_constant_2d",
            "build",
            [two.clone(), vec![rectangle]].concat(),
            "weights, 6, 3, u_range, v_range, marginal, conditional",
        ),
        (
            "LatLongMap",
            "lat_long_map",
            "build",
            two,
            "weights, 6, 3, marginal, conditional",
        ),
        (
            "Mesh",
            "mesh_u16",
            "init_trusted",
            mesh,
            "vertices, 6, faces, 6, of_faces, entries",
        ),
    ];
    let all = all
        .into_iter()
        .map(|(subject, name, init, lines, arguments)| {
            let warp = handles.iter().find(|warp| warp.name == name);
            let warp = warp.expect("a table of this name is bound");
            let made = Made {
                warp,
                lines,
                init: init.into(),
                arguments: arguments.into(),
            };
            (subject, made)
        });
    all.collect()
}
