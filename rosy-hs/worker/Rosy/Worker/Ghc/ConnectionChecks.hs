{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Ghc.ConnectionChecks
-- Description : Check of each function of a controller by itself.
--
-- GHC reports only the first unsolved class constraint of an expression, so of @simulate (f, g, h)@ one wrong function at a time. Here each
-- function is checked again in a declaration of its own, whose span is that of the function's definition.
module Rosy.Worker.Ghc.ConnectionChecks
  ( isConnectionError,
    withConnectionChecks,
  )
where

import qualified Data.Text as Text
import GHC.Hs
import GHC.Types.Name.Occurrence (mkDataOcc, mkVarOcc, occNameString)
import GHC.Types.Name.Reader (mkRdrUnqual, rdrNameOcc)
import GHC.Types.SrcLoc (unLoc)
import Rosy.Worker.CompilerMessage (CompilerMessage (..))
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.DeclaredTypes (added)

-- | Whether a message is about a type that is no input or no output.
isConnectionError :: CompilerMessage -> Bool
isConnectionError m = any (\t -> any (`Text.isPrefixOf` Text.stripStart t) ["No instance for (Sensor ", "No instance for (Command "]) (important m)

-- | Adds the checks of the functions of these names.
withConnectionChecks :: [String] -> SyntaxTree -> SyntaxTree
withConnectionChecks names tree = tree {hsmodDecls = hsmodDecls tree ++ concat [checks d | d <- hsmodDecls tree]}
  where
    checks :: LHsDecl GhcPs -> [LHsDecl GhcPs]
    checks l@(At at d) = case d of
      ValD _ b -> [At at (ValD noExtField (unLoc (mkSimpleGeneratedFunBind at (mkRdrUnqual (mkVarOcc ("check$" ++ n))) [] (connected n)))) | n <- take 1 (map (occNameString . rdrNameOcc) (boundNames b)), n `elem` names, spanOf l == at]
      _ -> []
    connected n = nlHsApp (nlHsApp (nlHsVar (added (mkVarOcc "simulateNamed"))) (nlHsApp (nlHsVar (added (mkDataOcc "Names"))) (nlList []))) (nlHsVar (mkRdrUnqual (mkVarOcc n)))
