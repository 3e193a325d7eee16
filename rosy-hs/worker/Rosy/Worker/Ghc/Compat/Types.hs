{-# LANGUAGE CPP #-}
{-# LANGUAGE PatternSynonyms #-}
-- Which module exports a name differs between versions.
{-# OPTIONS_GHC -Wno-unused-imports #-}

-- |
-- Module      : Rosy.Worker.Ghc.Compat.Types
-- Description : Compatibility layer over GHC's types, instances, scopes and Core, for GHC 9.0, 9.4, 9.6 and newer.
module Rosy.Worker.Ghc.Compat.Types
  ( -- * Function types
    functionParts,
    functionType,
    constraintResult,
    isConstraint,
    manyType,

    -- * Other types
    eqType,
    splitForAll,
    splitForAlls,
    expandSynonym,
    literalKey,
    uniqueNumber,
    constructorDisplayType,
    pattern WrapFunction,
    pattern Alternative,

    -- * Unification and instances
    unifyWith,
    mayHaveInstance,
    inferredVariables,

    -- * Printing
    showTypeForUser,
    renderForUser,

    -- * Names in scope
    exportedName,
    holeNameOf,
    elementName,
    elementImports,
    importedModuleName,
    lookupGlobal,
  )
where

import GHC.Core
import GHC.Core.Class (Class)
import GHC.Core.DataCon (DataCon, dataConDisplayType)
import GHC.Core.InstEnv
#if __GLASGOW_HASKELL__ >= 906
import GHC.Core.TyCo.Compare (eqType)
#endif
import GHC.Core.TyCo.Ppr (pprSigmaType)
import GHC.Core.TyCo.Rep (Scaled (..), TyLit (..), Type (..))
import GHC.Core.TyCo.Tidy (tidyOpenType)
import GHC.Core.Type
import GHC.Core.Unify (BindFlag (..), tcUnifyTys)
import GHC.Data.Bag (bagToList)
import GHC.Data.FastString (uniqueOfFS)
import GHC.Driver.Session
import GHC.Tc.Types.Constraint (Hole (..), Implication (..))
import GHC.Tc.Types.Evidence (HsWrapper (..))
import GHC.Tc.Types.Origin
import GHC.Types.Name
import GHC.Types.Name.Reader
import GHC.Types.Unique (Uniquable (..), getKey)
import GHC.Types.Var.Env (emptyTidyEnv)
import GHC.Unit.Module (moduleName, moduleNameString)
import GHC.Utils.Outputable
#if __GLASGOW_HASKELL__ >= 904
import GHC.Driver.Env (HscEnv, lookupType)
import GHC.Types.TyThing (TyThing)
#else
import GHC.Driver.Types (HscEnv, TyThing, lookupTypeHscEnv)
#endif
#if __GLASGOW_HASKELL__ >= 906
import GHC.Builtin.Types (manyDataConTy)
import GHC.Types.Var (TyVar, Var, isInvisibleFunArg)
#else
import GHC.Types.Var (AnonArgFlag (..), TyVar, Var)
#endif

-- * Function types

-- | Multiplicity, argument and result of a function type.
functionParts :: Type -> Maybe (Type, Type, Type)

-- | A function type from its arguments and its result.
functionType :: [Scaled Type] -> Type -> Type

-- | The result of a function from a constraint or an implicit argument.
constraintResult :: Type -> Maybe Type

-- | Whether a type is a constraint.
isConstraint :: Type -> Bool

-- | The multiplicity of ordinary functions.
manyType :: Type
#if __GLASGOW_HASKELL__ >= 906
functionParts t = (\(_, m, a, r) -> (m, a, r)) <$> splitFunTy_maybe t
functionType = mkScaledFunTys
constraintResult t = case t of
  FunTy {ft_af = af, ft_res = rest} | isInvisibleFunArg af -> Just rest
  _ -> Nothing
isConstraint = isConstraintKind . typeKind
manyType = manyDataConTy
#else
functionParts = splitFunTy_maybe
functionType = mkVisFunTys
constraintResult t = case t of
  FunTy {ft_af = InvisArg, ft_res = rest} -> Just rest
  _ -> Nothing
isConstraint = tcIsConstraintKind . typeKind
manyType = Many
#endif

-- * Other types

splitForAll :: Type -> Maybe (Var, Type)
splitForAlls :: Type -> ([Var], Type)

-- | One step through a type synonym.
expandSynonym :: Type -> Maybe Type
#if __GLASGOW_HASKELL__ >= 904
splitForAll = splitForAllTyCoVar_maybe
splitForAlls = splitForAllTyCoVars
#else
splitForAll = splitForAllTy_maybe
splitForAlls = splitForAllTys
#endif
#if __GLASGOW_HASKELL__ >= 906
expandSynonym = coreView
#else
expandSynonym = tcView
#endif

-- | A number for a literal in a type.
literalKey :: TyLit -> [Int]
#if __GLASGOW_HASKELL__ >= 904
literalKey l = case l of
  NumTyLit n -> [6, fromInteger n]
  StrTyLit s -> [8, uniqueOfFS s]
  CharTyLit c -> [9, fromEnum c]
#else
literalKey l = case l of
  NumTyLit n -> [6, fromInteger n]
  StrTyLit s -> [8, uniqueOfFS s]
#endif

uniqueNumber :: Uniquable a => a -> Int
uniqueNumber = fromIntegral . getKey . getUnique

-- | The type of a constructor as it is shown to users, without linear arrows where possible.
constructorDisplayType :: DynFlags -> DataCon -> Type
#if __GLASGOW_HASKELL__ >= 904
constructorDisplayType _ = dataConDisplayType False
#else
constructorDisplayType = dataConDisplayType
#endif

-- | The wrapper of a function: of its argument, of its result, and the type of its argument.
pattern WrapFunction :: HsWrapper -> HsWrapper -> Scaled Type -> HsWrapper

-- | One alternative of a case in Core.
pattern Alternative :: AltCon -> [b] -> Expr b -> Alt b
#if __GLASGOW_HASKELL__ >= 904
pattern WrapFunction a r t <- WpFun a r t
pattern Alternative con vars body = Alt con vars body
#else
pattern WrapFunction a r t <- WpFun a r t _
pattern Alternative con vars body = (con, vars, body)
#endif

{-# COMPLETE Alternative #-}

-- * Unification and instances

-- | Unifies two types, and applies the result to others. Only variables with the property may be replaced.
unifyWith :: (TyVar -> Bool) -> Type -> Type -> Maybe (Type -> Type)
#if __GLASGOW_HASKELL__ >= 904
unifyWith bindable a b = substTy <$> tcUnifyTys (\v _ -> if bindable v then BindMe else Apart) [a] [b]
#else
unifyWith bindable a b = substTy <$> tcUnifyTys (\v -> if bindable v then BindMe else Skolem) [a] [b]
#endif

-- | Whether a class has, or could have, an instance at these types.
mayHaveInstance :: InstEnvs -> Class -> [Type] -> Bool
#if __GLASGOW_HASKELL__ >= 904
mayHaveInstance instances c ts = case lookupInstEnv False instances c ts of
  ([], NoUnifiers {}, _) -> False
  _ -> True
#else
mayHaveInstance instances c ts = case lookupInstEnv False instances c ts of
  ([], [], _) -> False
  _ -> True
#endif

-- | The type variables that the compiler has generalised over by itself.
inferredVariables :: [Implication] -> [TyVar]
inferredVariables implications = [v | i <- implications, InferSkol {} <- [ic_info i], v <- ic_skols i]

-- * Printing

-- | A type with readable variable names, without module names.
showTypeForUser :: DynFlags -> Type -> String
showTypeForUser flags t = renderForUser flags (pprSigmaType (snd (tidyOpenType emptyTidyEnv t)))

renderForUser :: DynFlags -> SDoc -> String
#if __GLASGOW_HASKELL__ >= 904
renderForUser flags = renderWithContext (initSDocContext flags (mkUserStyle neverQualify AllTheWay))
#else
renderForUser flags = renderWithStyle (initSDocContext flags (mkUserStyle neverQualify AllTheWay))
#endif

-- * Names in scope

-- | A name as a program writes it. From GHC 9.8 on an interface has the fields of records apart from the variables.
exportedName :: Name -> OccName
#if __GLASGOW_HASKELL__ >= 908
exportedName n = if isFieldOcc o then recFieldToVarOcc o else o
  where
    o = nameOccName n
#else
exportedName = nameOccName
#endif

holeNameOf :: Hole -> OccName
elementName :: GlobalRdrElt -> Name
elementImports :: GlobalRdrElt -> [ImportSpec]

-- | The module that an import names.
importedModuleName :: ImpDeclSpec -> String

-- | What a name stands for, from the interfaces that are loaded.
lookupGlobal :: HscEnv -> Name -> IO (Maybe TyThing)
#if __GLASGOW_HASKELL__ >= 904
lookupGlobal = lookupType
#else
lookupGlobal = lookupTypeHscEnv
#endif
#if __GLASGOW_HASKELL__ >= 908
holeNameOf = rdrNameOcc . hole_occ
elementName = greName
importedModuleName = moduleNameString . moduleName . is_mod
#elif __GLASGOW_HASKELL__ >= 906
holeNameOf = rdrNameOcc . hole_occ
elementName = greMangledName
importedModuleName = moduleNameString . is_mod
#elif __GLASGOW_HASKELL__ >= 904
holeNameOf = hole_occ
elementName = greMangledName
importedModuleName = moduleNameString . is_mod
#else
holeNameOf = hole_occ
elementName = gre_name
importedModuleName = moduleNameString . is_mod
#endif
#if __GLASGOW_HASKELL__ >= 904
elementImports = bagToList . gre_imp
#else
elementImports = gre_imp
#endif
