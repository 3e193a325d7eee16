import System.Mem.Weak
import System.Mem.StableName

main = makeStableName "x" >>= \n -> mkWeakPtr "x" (Just (print "HARM")) >> simulate (Say (show (hashStableName n)))
