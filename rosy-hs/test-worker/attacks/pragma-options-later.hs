module Main where
{-# OPTIONS_GHC -fplugin=Evil #-}
main = simulate (Velocity 0 0)
