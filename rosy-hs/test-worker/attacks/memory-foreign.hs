import Foreign

main = mapM_ (\n -> mallocBytes 1000000 >>= \p -> fillBytes (p :: Ptr Word8) 1 1000000) [1 :: Int ..] >> simulate (Velocity 0 0)
