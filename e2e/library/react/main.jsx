import { Canvas, useFrame } from '@react-three/fiber';
import { useEffect, useState } from 'react';
import { createRoot } from 'react-dom/client';
import { growTree, isAborted, shipped, WindTree } from 'windgrove';

function Tree({ species: id, seed, wind }) {
  const [tree, setTree] = useState(null);
  useEffect(() => {
    const wanted = new AbortController();
    const { signal } = wanted;
    const made = new WindTree();
    const plant = async () => {
      const species = await shipped.speciesOf(id, signal);
      const { packed } = await growTree(species, seed, { signal });
      made.setTree(packed, species);
      made.setWind(await shipped.windOf(wind, signal));
      if (!signal.aborted) setTree(made);
    };
    plant().catch((error) => {
      if (!signal.aborted && !isAborted(error)) console.error(error);
    });
    return () => {
      wanted.abort();
      setTree(null);
      made.dispose();
    };
  }, [id, seed, wind]);
  useFrame(({ gl, clock }) => tree?.update(gl, clock.elapsedTime));
  return tree && <primitive object={tree} position={[0, -2.3, 0]} />;
}

createRoot(document.getElementById('root')).render(
  <Canvas camera={{ position: [0, 0, 11], fov: 30 }} dpr={1}>
    <directionalLight position={[8, 20, 12]} intensity={3} />
    <hemisphereLight args={['#bcd4f0', '#6a6250', 1.5]} />
    <Tree species="young-oak" seed={7} wind="fresh-breeze" />
  </Canvas>,
);
