// What the page with two ellipsoids shows, by three.js. The world is turned, and scaled to fit into the picture; the camera stands
// still. Distances of the scene are those of space, times the scale of the world.
"use strict";

// The rotation of a quaternion (w, x, y, z).
const rotation = ([w, x, y, z]) => new THREE.Quaternion(x, y, z, w).normalize();

// The scene of a canvas, or null where there is no WebGL. Colours are those of the two ellipsoids.
function makeScene(canvas, colours) {
    const OPENING = 25; // of the camera, in degrees
    const attributes = {alpha: true, antialias: true, preserveDrawingBuffer: true};
    const context = canvas.getContext("webgl2", attributes) || canvas.getContext("webgl", attributes);
    if (!context) return null;
    const renderer = new THREE.WebGLRenderer({canvas, context, ...attributes});
    const scene = new THREE.Scene(), world = new THREE.Group(), camera = new THREE.PerspectiveCamera(OPENING);
    const vector = x => new THREE.Vector3(...x);

    // The circles in which the principal planes meet a unit sphere, just above it.
    function circles(material) {
        const group = new THREE.Group(), angles = [...Array(97).keys()].map(i => i * Math.PI / 48), radius = 1.002;
        for (const turn of [[0, 0, 0], [Math.PI / 2, 0, 0], [0, Math.PI / 2, 0]]) {
            const points = angles.map(t => new THREE.Vector3(radius * Math.cos(t), radius * Math.sin(t), 0));
            const circle = new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), material);
            circle.rotation.set(...turn);
            group.add(circle);
        }
        return group;
    }

    // A unit sphere, to be stretched.
    function sphere(material, lines) {
        const mesh = new THREE.Mesh(new THREE.SphereGeometry(1, 64, 32), material);
        mesh.add(circles(lines));
        world.add(mesh);
        return mesh;
    }

    const solids = colours.map(color =>
        sphere(new THREE.MeshPhongMaterial({color, shininess: 20}), new THREE.LineBasicMaterial({color: "white"})));
    const scaled = colours.map(color =>
        sphere(new THREE.MeshPhongMaterial({color, transparent: true, opacity: 0.25, depthWrite: false}),
            new THREE.LineBasicMaterial({color, transparent: true})));

    // Marks are seen through everything. The normal points along y before it is turned.
    const ink = new THREE.MeshBasicMaterial({depthTest: false, transparent: true});
    const contact = new THREE.Group();
    for (const [geometry, height] of [[new THREE.SphereGeometry(0.022, 16, 16), 0],
        [new THREE.CylinderGeometry(0.007, 0.007, 0.3), 0.15], [new THREE.ConeGeometry(0.022, 0.07, 16), 0.33]]) {
        const mark = new THREE.Mesh(geometry, ink);
        mark.position.y = height;
        mark.renderOrder = 1;
        contact.add(mark);
    }
    const gap = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({depthTest: false, transparent: true}));
    gap.renderOrder = 1;
    gap.frustumCulled = false;
    world.add(contact, gap);

    const light = new THREE.DirectionalLight("white", 0.8);
    light.position.set(-0.4, 0.7, 0.8);
    scene.add(world, light, new THREE.AmbientLight("white", 0.4));

    function place(mesh, k, state, factor) {
        mesh.position.copy(vector(k === 0 ? [0, 0, 0] : state.r12));
        mesh.quaternion.copy(rotation(state.quaternions[k]));
        mesh.scale.copy(vector(state.axes[k])).multiplyScalar(factor);
    }

    // Inside of the solid ones, the scaled ellipsoids are seen through them.
    function placeScaled(state, mu) {
        scaled.forEach((mesh, k) => {
            mesh.visible = mu > 0;
            mesh.material.depthTest = mesh.children[0].children[0].material.depthTest = mu >= 1;
            place(mesh, k, state, mu);
        });
    }

    function placeMarks(result, size) {
        contact.visible = result.mu2 > 0;
        contact.position.copy(vector(result.point));
        contact.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), vector(result.normal));
        contact.scale.setScalar(size);
        gap.visible = result.distance > 0;
        gap.geometry.setFromPoints(result.closest.map(vector));
    }

    // A sphere of radius 1 around the middle of the centres fits into the picture.
    function placeWorld(state, size) {
        const factor = state.scale / size;
        world.quaternion.copy(rotation(state.view));
        world.scale.setScalar(factor);
        world.position.copy(vector(state.r12)).multiplyScalar(-factor / 2).applyQuaternion(world.quaternion);
    }

    function placeCamera(width, height) {
        const half = Math.atan(Math.tan(OPENING / 2 * Math.PI / 180) * Math.min(1, width / height));
        camera.position.z = 1.06 / Math.sin(half);
        camera.near = camera.position.z / 100;
        camera.far = 100 * camera.position.z;
        camera.aspect = width / height;
        camera.updateProjectionMatrix();
        renderer.setPixelRatio(window.devicePixelRatio || 1);
        renderer.setSize(width, height, false);
    }

    function draw(state, result, selected) {
        const size = Math.max(...state.axes.flat()) + vector(state.r12).length() / 2;
        const written = getComputedStyle(canvas).color.match(/[\d.]+/g).slice(0, 3);
        for (const material of [ink, gap.material]) material.color.set(`rgb(${written})`);
        solids.forEach((mesh, k) => {
            place(mesh, k, state, 1);
            for (const circle of mesh.children[0].children) circle.visible = k === selected;
        });
        placeScaled(state, Math.sqrt(result.mu2));
        placeMarks(result, size);
        placeWorld(state, size);
        placeCamera(canvas.clientWidth, canvas.clientHeight);
        renderer.render(scene, camera);
    }

    // Which ellipsoid is seen at a place of the picture, in pixels; -1 if none.
    function at(x, y) {
        const ray = new THREE.Raycaster();
        ray.setFromCamera(new THREE.Vector2(2 * x / canvas.clientWidth - 1, 1 - 2 * y / canvas.clientHeight), camera);
        const hits = ray.intersectObjects(solids, false);
        return hits.length ? solids.indexOf(hits[0].object) : -1;
    }

    // How far one moves an ellipsoid, in units of space, to move it by a pixel.
    function unitsPerPixel(k) {
        const depth = camera.position.z - solids[k].getWorldPosition(new THREE.Vector3()).z;
        return 2 * depth * Math.tan(OPENING / 2 * Math.PI / 180) / canvas.clientHeight / world.scale.x;
    }

    return {draw, at, unitsPerPixel};
}
