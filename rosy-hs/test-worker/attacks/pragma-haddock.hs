{-# OPTIONS_HADDOCK hide #-}
{-# LANGUAGE Safe, Unsafe #-}
module Main where

main = simulate (Say "HARM")
