//! Reading SVG.

use roxmltree::{Document, Node};

/// Elements with a class.
pub(crate) fn classed<'a>(svg: &'a Document<'a>, class: &str) -> Vec<Node<'a, 'a>> {
    let has = |node: &Node<'_, '_>| {
        let classes = node.attribute("class").unwrap_or_default();
        classes.split(' ').any(|word| word == class)
    };
    svg.descendants().filter(has).collect()
}

/// Words of elements with a class.
pub(crate) fn words<'a>(svg: &'a Document<'a>, class: &str) -> Vec<&'a str> {
    let elements = classed(svg, class).into_iter();
    elements.filter_map(|element| element.text()).collect()
}

pub(crate) fn number(node: Node<'_, '_>, attribute: &str) -> f64 {
    node.attribute(attribute).unwrap().parse().unwrap()
}

/// Corners of a polyline or polygon.
pub(crate) fn corners(node: Node<'_, '_>) -> Vec<[f64; 2]> {
    let points = node.attribute("points").unwrap().split(' ');
    let corner = |pair: &str| {
        let (x, y) = pair.split_once(',').unwrap();
        [x.parse().unwrap(), y.parse().unwrap()]
    };
    points.map(corner).collect()
}

/// Polylines within elements with a class.
pub(crate) fn lines<'a>(svg: &'a Document<'a>, class: &str) -> Vec<Node<'a, 'a>> {
    let groups = classed(svg, class).into_iter();
    let lines = groups.flat_map(|group| group.descendants());
    lines.filter(|node| node.has_tag_name("polyline")).collect()
}
