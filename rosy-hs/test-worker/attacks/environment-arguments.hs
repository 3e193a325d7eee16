import System.Environment

main = getArgs >>= \as -> getProgName >>= \n -> getExecutablePath >>= \p -> simulate (Say (concat (p : n : as)))
