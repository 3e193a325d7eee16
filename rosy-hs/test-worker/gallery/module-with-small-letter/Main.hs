module main where

main = simulate (drive 50)
