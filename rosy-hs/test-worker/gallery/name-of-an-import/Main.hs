import Data.List

main = simulate insert

insert :: Bumper -> Sound
insert _ = ErrorSound
