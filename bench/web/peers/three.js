// three.js as its examples use it: GLTFLoader, HDRLoader, PMREM made by the renderer.
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { HDRLoader } from "three/addons/loaders/HDRLoader.js";
import { canvasIn, finished, run } from "../page.js";

run(async (host, { model, environment, width, height, fov, distance, multisampled }) => {
  const renderer = new THREE.WebGLRenderer({ canvas: canvasIn(host, { width, height }), antialias: multisampled });
  renderer.toneMapping = THREE.NoToneMapping;
  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera((fov * 180) / Math.PI, width / height, 0.1, 100);
  const hdr = new HDRLoader().setDataType(THREE.FloatType);
  const take = (texture) => {
    texture.mapping = THREE.EquirectangularReflectionMapping;
    scene.background = scene.environment = texture;
  };
  const draw = (angle) => {
    camera.position.set(distance * Math.sin(angle), 0, distance * Math.cos(angle));
    camera.lookAt(0, 0, 0);
    renderer.render(scene, camera);
    finished(renderer.getContext());
  };
  const [gltf, texture] = await Promise.all([new GLTFLoader().loadAsync(model), hdr.loadAsync(environment)]);
  scene.add(gltf.scene);
  take(texture);
  draw(0);
  return {
    async frame(angle) { draw(angle); },
    async light(bytes) {
      scene.background.dispose();
      const { data, width, height } = hdr.parse(bytes.buffer);
      const next = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.FloatType);
      Object.assign(next, { minFilter: THREE.LinearFilter, magFilter: THREE.LinearFilter, flipY: true, generateMipmaps: false, needsUpdate: true });
      take(next);
      draw(0);
    },
    async rest() { draw(0); },
  };
});
