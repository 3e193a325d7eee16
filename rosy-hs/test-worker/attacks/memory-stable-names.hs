import Foreign.StablePtr
import System.Mem.StableName

main = mapM_ (\n -> newStablePtr [n] >> makeStableName n) [1 :: Int ..] >> simulate (Velocity 0 0)
