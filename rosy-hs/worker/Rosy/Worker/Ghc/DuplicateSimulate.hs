-- |
-- Module      : Rosy.Worker.Ghc.DuplicateSimulate
-- Description : Detection of a second @simulate@ in @main@.
--
-- A program runs one robot once. A second @simulate@ is never reached or ends the run with a problem; where @main@ evidently runs one after
-- the other, it is reported before the run.
module Rosy.Worker.Ghc.DuplicateSimulate
  ( duplicateSimulate,
  )
where

import qualified Data.Map.Strict as Map
import GHC.Hs
import GHC.Types.Name.Occurrence (occNameString)
import GHC.Types.Name.Reader (RdrName, isUnqual, rdrNameOcc)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.FunctionNames (definitionsOf)

-- | The span of the second @simulate@.
duplicateSimulate :: SyntaxTree -> Maybe SrcSpan
duplicateSimulate parsed = case Map.lookup "main" definitions of
  Just ([], body) | Map.notMember "simulate" definitions, _ : second : _ <- inOrder depth body -> Just second
  _ -> Nothing
  where
    definitions = definitionsOf [L at b | L at (ValD _ b) <- hsmodDecls parsed]
    -- Bounds the resolution of recursive definitions.
    depth = 8

    -- Every simulate that is certainly executed, in order. One of two branches is.
    inOrder :: Int -> LHsExpr GhcPs -> [SrcSpan]
    inOrder n located@(At at e) = case e of
      Paren x -> inOrder n x
      LetIn _ x -> inOrder n x
      HsDo _ _ (L _ statements) -> concatMap (statement n) statements
      OpApp _ a (L _ (HsVar _ (L _ op))) b
        | plain op `elem` [">>", "*>", "<*"] -> inOrder n a ++ inOrder n b
        | plain op == "$" -> [at | calls a]
      HsIf _ _ a b -> let (x, y) = (inOrder n a, inOrder n b) in if length x >= length y then x else y
      HsVar _ (L _ v) | n > 0, isUnqual v, Just ([], body) <- Map.lookup (plain v) definitions -> take 1 [at | _ : _ <- [inOrder (n - 1) body]]
      _ -> [at | calls located]
    statement :: Int -> ExprLStmt GhcPs -> [SrcSpan]
    statement n (L _ s) = case s of
      BodyStmt _ x _ _ -> inOrder n x
      LastStmt _ x _ _ -> inOrder n x
      BindStmt _ _ x -> inOrder n x
      _ -> []
    calls :: LHsExpr GhcPs -> Bool
    calls (L _ e) = case e of
      HsApp _ f _ -> calls f
      Paren x -> calls x
      HsVar _ (L _ v) -> isUnqual v && plain v == "simulate"
      _ -> False

plain :: RdrName -> String
plain = occNameString . rdrNameOcc
