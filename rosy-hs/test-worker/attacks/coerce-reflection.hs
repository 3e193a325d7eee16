{-# LANGUAGE ScopedTypeVariables #-}
import Type.Reflection.Unsafe

main = simulate (Say (show (typeRepFingerprint undefined)))
