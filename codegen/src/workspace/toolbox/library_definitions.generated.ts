/// Made by scripts/definitions.ts from rosy-hs/src/Rosy/Motion.hs; not edited by hand.

export const generated: unknown = [
 {
  "name": "drive",
  "block": {
   "type": "define",
   "extraState": {
    "name": "drive",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": "Centimeters -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "distance"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "task",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "startDrive",
          "args": 0
         }
        }
       },
       "A1": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "runDrive",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "centimetersToMeters",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "distance",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Drive so many centimetres ahead (back if negative), keep the heading, and stand still."
    }
   }
  }
 },
 {
  "name": "startDrive",
  "block": {
   "type": "define",
   "extraState": {
    "name": "startDrive",
    "as": "plain",
    "arity": 0,
    "equations": [
     {}
    ],
    "signature": "Pose -> Memory Pose"
   },
   "inputs": {
    "E0_0": {
     "block": {
      "type": "construct",
      "extraState": {
       "con": "Memory",
       "args": 0
      }
     }
    }
   }
  }
 },
 {
  "name": "runDrive",
  "block": {
   "type": "define",
   "extraState": {
    "name": "runDrive",
    "as": "plain",
    "arity": 4,
    "equations": [
     {
      "guards": 1,
      "otherwise": true,
      "where": true
     }
    ],
    "signature": "Meters -> Memory Pose -> Pose -> Velocity -> (Velocity, Maybe (Done ()))"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "goal"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Memory",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Pose",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "start"
            }
           }
          },
          "A1": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "heading"
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "P0_2": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Pose",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "here"
         }
        }
       },
       "A1": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "facing"
         }
        }
       }
      }
     }
    },
    "P0_3": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Velocity",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "v"
         }
        }
       },
       "A1": {
        "block": {
         "type": "pattern_any",
         "extraState": {
          "what": "turning, radians a second"
         }
        }
       }
      }
     }
    },
    "C0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "abs",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "rest",
             "args": 0
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "number",
         "extraState": {
          "value": "0.003"
         }
        }
       }
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 2
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "approach",
             "args": 4
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.05"
               }
              }
             },
             "A1": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.3"
               }
              }
             },
             "A2": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.4"
               }
              }
             },
             "A3": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "rest",
                "args": 0
               }
              }
             }
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "steer",
             "args": 0
            }
           }
          }
         }
        }
       },
       "I1": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Nothing",
          "args": 0
         }
        }
       }
      }
     }
    },
    "O0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 2
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          },
          "A1": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          }
         }
        }
       },
       "I1": {
        "block": {
         "type": "if",
         "inputs": {
          "C": {
           "block": {
            "type": "infix",
            "extraState": {
             "op": "<"
            },
            "inputs": {
             "L": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "abs",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "v",
                   "args": 0
                  }
                 }
                }
               }
              }
             },
             "R": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.01"
               }
              }
             }
            }
           }
          },
          "T": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Just",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Done",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "tuple",
                  "extraState": {
                   "items": 0
                  }
                 }
                }
               }
              }
             }
            }
           }
          },
          "F": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Nothing",
             "args": 0
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "W0": {
     "block": {
      "type": "define_pattern",
      "inputs": {
       "P": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Orientation",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "course"
            }
           }
          }
         }
        }
       },
       "E0_0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "heading",
          "args": 0
         }
        }
       }
      },
      "next": {
       "block": {
        "type": "define_pattern",
        "inputs": {
         "P": {
          "block": {
           "type": "pattern_construct",
           "extraState": {
            "con": "Orientation",
            "args": 1
           },
           "inputs": {
            "A0": {
             "block": {
              "type": "pattern_name",
              "extraState": {
               "name": "deviation"
              }
             }
            }
           }
          }
         },
         "E0_0": {
          "block": {
           "type": "name",
           "extraState": {
            "name": "normOrientation",
            "args": 1
           },
           "inputs": {
            "A0": {
             "block": {
              "type": "infix",
              "extraState": {
               "op": "-"
              },
              "inputs": {
               "L": {
                "block": {
                 "type": "name",
                 "extraState": {
                  "name": "heading",
                  "args": 0
                 }
                }
               },
               "R": {
                "block": {
                 "type": "name",
                 "extraState": {
                  "name": "facing",
                  "args": 0
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        },
        "next": {
         "block": {
          "type": "define_pattern",
          "inputs": {
           "P": {
            "block": {
             "type": "pattern_tuple",
             "extraState": {
              "items": 2
             },
             "inputs": {
              "I0": {
               "block": {
                "type": "pattern_name",
                "extraState": {
                 "name": "x"
                }
               }
              },
              "I1": {
               "block": {
                "type": "pattern_name",
                "extraState": {
                 "name": "y"
                }
               }
              }
             }
            }
           },
           "E0_0": {
            "block": {
             "type": "infix",
             "extraState": {
              "op": "subVec"
             },
             "inputs": {
              "L": {
               "block": {
                "type": "name",
                "extraState": {
                 "name": "positionToVec",
                 "args": 1
                },
                "inputs": {
                 "A0": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "here",
                    "args": 0
                   }
                  }
                 }
                }
               }
              },
              "R": {
               "block": {
                "type": "name",
                "extraState": {
                 "name": "positionToVec",
                 "args": 1
                },
                "inputs": {
                 "A0": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "start",
                    "args": 0
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          },
          "next": {
           "block": {
            "type": "define",
            "extraState": {
             "name": "rest",
             "as": "plain",
             "arity": 0,
             "equations": [
              {}
             ]
            },
            "inputs": {
             "E0_0": {
              "block": {
               "type": "infix",
               "extraState": {
                "op": "-"
               },
               "inputs": {
                "L": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "goal",
                   "args": 0
                  }
                 }
                },
                "R": {
                 "block": {
                  "type": "infix",
                  "extraState": {
                   "op": "+"
                  },
                  "inputs": {
                   "L": {
                    "block": {
                     "type": "infix",
                     "extraState": {
                      "op": "*"
                     },
                     "inputs": {
                      "L": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "x",
                         "args": 0
                        }
                       }
                      },
                      "R": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "cos",
                         "args": 1
                        },
                        "inputs": {
                         "A0": {
                          "block": {
                           "type": "name",
                           "extraState": {
                            "name": "course",
                            "args": 0
                           }
                          }
                         }
                        }
                       }
                      }
                     }
                    }
                   },
                   "R": {
                    "block": {
                     "type": "infix",
                     "extraState": {
                      "op": "*"
                     },
                     "inputs": {
                      "L": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "y",
                         "args": 0
                        }
                       }
                      },
                      "R": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "sin",
                         "args": 1
                        },
                        "inputs": {
                         "A0": {
                          "block": {
                           "type": "name",
                           "extraState": {
                            "name": "course",
                            "args": 0
                           }
                          }
                         }
                        }
                       }
                      }
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            },
            "next": {
             "block": {
              "type": "define",
              "extraState": {
               "name": "steer",
               "as": "plain",
               "arity": 0,
               "equations": [
                {}
               ]
              },
              "inputs": {
               "E0_0": {
                "block": {
                 "type": "name",
                 "extraState": {
                  "name": "max",
                  "args": 2
                 },
                 "inputs": {
                  "A0": {
                   "block": {
                    "type": "number",
                    "extraState": {
                     "value": "-0.5"
                    }
                   }
                  },
                  "A1": {
                   "block": {
                    "type": "name",
                    "extraState": {
                     "name": "min",
                     "args": 2
                    },
                    "inputs": {
                     "A0": {
                      "block": {
                       "type": "number",
                       "extraState": {
                        "value": "0.5"
                       }
                      }
                     },
                     "A1": {
                      "block": {
                       "type": "infix",
                       "extraState": {
                        "op": "*"
                       },
                       "inputs": {
                        "L": {
                         "block": {
                          "type": "number",
                          "extraState": {
                           "value": "2"
                          }
                         }
                        },
                        "R": {
                         "block": {
                          "type": "name",
                          "extraState": {
                           "name": "deviation",
                           "args": 0
                          }
                         }
                        }
                       }
                      }
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   }
  }
 },
 {
  "name": "turn",
  "block": {
   "type": "define",
   "extraState": {
    "name": "turn",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": "Degrees -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "angle"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "task",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "startTurn",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "degreesToRadians",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "angle",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "A1": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "runTurn",
          "args": 0
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Turn by so many degrees on the spot, to the left (to the right if negative), and stand still."
    }
   }
  }
 },
 {
  "name": "startTurn",
  "block": {
   "type": "define",
   "extraState": {
    "name": "startTurn",
    "as": "plain",
    "arity": 2,
    "equations": [
     {}
    ],
    "signature": "Radians -> Orientation -> Memory (Radians, Orientation)"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "angle"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "heading"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "construct",
      "extraState": {
       "con": "Memory",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "tuple",
         "extraState": {
          "items": 2
         },
         "inputs": {
          "I0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "angle",
             "args": 0
            }
           }
          },
          "I1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "heading",
             "args": 0
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| The angle that is still to turn (radians), and the last heading. It counts whole turns, which a heading does not."
    }
   }
  }
 },
 {
  "name": "runTurn",
  "block": {
   "type": "define",
   "extraState": {
    "name": "runTurn",
    "as": "memory",
    "arity": 3,
    "equations": [
     {
      "guards": 1,
      "otherwise": true,
      "where": true
     }
    ],
    "signature": "Memory (Radians, Orientation) -> Orientation -> Velocity -> (Memory (Radians, Orientation), Velocity, Maybe (Done ()))"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Memory",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_tuple",
         "extraState": {
          "items": 2
         },
         "inputs": {
          "I0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "before"
            }
           }
          },
          "I1": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "last'"
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "heading"
      }
     }
    },
    "P0_2": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Velocity",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_any",
         "extraState": {
          "what": "speed, metres a second"
         }
        }
       },
       "A1": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "w"
         }
        }
       }
      }
     }
    },
    "C0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "abs",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "rest",
             "args": 0
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "number",
         "extraState": {
          "value": "0.005"
         }
        }
       }
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 3
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "remaining",
          "args": 0
         }
        }
       },
       "I1": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "approach",
             "args": 4
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.15"
               }
              }
             },
             "A1": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "1.2"
               }
              }
             },
             "A2": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "1.5"
               }
              }
             },
             "A3": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "rest",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "I2": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Nothing",
          "args": 0
         }
        }
       }
      }
     }
    },
    "O0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 3
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "remaining",
          "args": 0
         }
        }
       },
       "I1": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          },
          "A1": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          }
         }
        }
       },
       "I2": {
        "block": {
         "type": "if",
         "inputs": {
          "C": {
           "block": {
            "type": "infix",
            "extraState": {
             "op": "<"
            },
            "inputs": {
             "L": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "abs",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "w",
                   "args": 0
                  }
                 }
                }
               }
              }
             },
             "R": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.02"
               }
              }
             }
            }
           }
          },
          "T": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Just",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Done",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "tuple",
                  "extraState": {
                   "items": 0
                  }
                 }
                }
               }
              }
             }
            }
           }
          },
          "F": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Nothing",
             "args": 0
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "W0": {
     "block": {
      "type": "define_pattern",
      "inputs": {
       "P": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Orientation",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "turned"
            }
           }
          }
         }
        }
       },
       "E0_0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "normOrientation",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "infix",
            "extraState": {
             "op": "-"
            },
            "inputs": {
             "L": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "heading",
                "args": 0
               }
              }
             },
             "R": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "last'",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       }
      },
      "next": {
       "block": {
        "type": "define",
        "extraState": {
         "name": "rest",
         "as": "plain",
         "arity": 0,
         "equations": [
          {}
         ]
        },
        "inputs": {
         "E0_0": {
          "block": {
           "type": "infix",
           "extraState": {
            "op": "-"
           },
           "inputs": {
            "L": {
             "block": {
              "type": "name",
              "extraState": {
               "name": "before",
               "args": 0
              }
             }
            },
            "R": {
             "block": {
              "type": "name",
              "extraState": {
               "name": "turned",
               "args": 0
              }
             }
            }
           }
          }
         }
        },
        "next": {
         "block": {
          "type": "define",
          "extraState": {
           "name": "remaining",
           "as": "plain",
           "arity": 0,
           "equations": [
            {}
           ]
          },
          "inputs": {
           "E0_0": {
            "block": {
             "type": "construct",
             "extraState": {
              "con": "Memory",
              "args": 1
             },
             "inputs": {
              "A0": {
               "block": {
                "type": "tuple",
                "extraState": {
                 "items": 2
                },
                "inputs": {
                 "I0": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "rest",
                    "args": 0
                   }
                  }
                 },
                 "I1": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "heading",
                    "args": 0
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   }
  }
 },
 {
  "name": "approach",
  "block": {
   "type": "define",
   "extraState": {
    "name": "approach",
    "as": "plain",
    "arity": 4,
    "equations": [
     {}
    ],
    "signature": "Double -> Double -> Double -> Double -> Double"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "slowest"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "fastest"
      }
     }
    },
    "P0_2": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "deceleration"
      }
     }
    },
    "P0_3": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "rest"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": "*"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "signum",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "rest",
             "args": 0
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "max",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "slowest",
             "args": 0
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "min",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "fastest",
                "args": 0
               }
              }
             },
             "A1": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "sqrt",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "infix",
                  "extraState": {
                   "op": "*"
                  },
                  "inputs": {
                   "L": {
                    "block": {
                     "type": "infix",
                     "extraState": {
                      "op": "*"
                     },
                     "inputs": {
                      "L": {
                       "block": {
                        "type": "number",
                        "extraState": {
                         "value": "2"
                        }
                       }
                      },
                      "R": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "deceleration",
                         "args": 0
                        }
                       }
                      }
                     }
                    }
                   },
                   "R": {
                    "block": {
                     "type": "name",
                     "extraState": {
                      "name": "abs",
                      "args": 1
                     },
                     "inputs": {
                      "A0": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "rest",
                         "args": 0
                        }
                       }
                      }
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| A speed towards a goal that is so far away: between a slowest and a fastest speed, such that a constant deceleration ends at the goal.\nTakes slowest, fastest, deceleration and distance, in metres or radians and seconds."
    }
   }
  }
 },
 {
  "name": "driveUntil",
  "block": {
   "type": "define",
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "ctrl"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "do",
      "inputs": {
       "S": {
        "block": {
         "type": "step_bind",
         "inputs": {
          "P": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "result"
            }
           }
          },
          "X": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "task",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Velocity",
                "args": 2
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0.2"
                  }
                 }
                },
                "A1": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0"
                  }
                 }
                }
               }
              }
             },
             "A1": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "ctrl",
                "args": 0
               }
              }
             }
            }
           }
          }
         },
         "next": {
          "block": {
           "type": "step_do",
           "inputs": {
            "X": {
             "block": {
              "type": "name",
              "extraState": {
               "name": "once",
               "args": 1
              },
              "inputs": {
               "A0": {
                "block": {
                 "type": "construct",
                 "extraState": {
                  "con": "Velocity",
                  "args": 2
                 },
                 "inputs": {
                  "A0": {
                   "block": {
                    "type": "number",
                    "extraState": {
                     "value": "0"
                    }
                   }
                  },
                  "A1": {
                   "block": {
                    "type": "number",
                    "extraState": {
                     "value": "0"
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            }
           },
           "next": {
            "block": {
             "type": "step_do",
             "inputs": {
              "X": {
               "block": {
                "type": "name",
                "extraState": {
                 "name": "pure",
                 "args": 1
                },
                "inputs": {
                 "A0": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "result",
                    "args": 0
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Drive ahead (0.2 m/s) until the controller gives 'Done', then stand still.\n\n> driveUntil (\\(Button _ _) -> Done ())"
    }
   },
   "extraState": {
    "name": "driveUntil",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": ""
   }
  },
  "typedByCall": true
 },
 {
  "name": "driveUntilBump",
  "block": {
   "type": "define",
   "extraState": {
    "name": "driveUntilBump",
    "as": "task",
    "arity": 0,
    "equations": [
     {
      "where": true
     }
    ],
    "signature": "Task BumperSide"
   },
   "inputs": {
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "driveUntil",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "bumped",
          "args": 0
         }
        }
       }
      }
     }
    },
    "W0": {
     "block": {
      "type": "define",
      "extraState": {
       "name": "bumped",
       "as": "event",
       "arity": 1,
       "equations": [
        {},
        {}
       ],
       "signature": "Bumper -> Maybe (Done BumperSide)"
      },
      "inputs": {
       "P0_0": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Bumper",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "side"
            }
           }
          },
          "A1": {
           "block": {
            "type": "pattern_choice",
            "extraState": {
             "of": "ButtonStatus",
             "value": "Pressed"
            }
           }
          }
         }
        }
       },
       "E0_0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Just",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Done",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "side",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "P1_0": {
        "block": {
         "type": "pattern_any",
         "extraState": {
          "what": "thing"
         }
        }
       },
       "E1_0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Nothing",
          "args": 0
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Drive ahead until a bumper is pressed, and stand still. Its result is the side of the bumper."
    }
   }
  }
 },
 {
  "name": "driveBack",
  "block": {
   "type": "define",
   "extraState": {
    "name": "driveBack",
    "as": "state",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": "Seconds -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "time"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">>"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "infix",
         "extraState": {
          "op": ">>"
         },
         "inputs": {
          "L": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "once",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Velocity",
                "args": 2
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "-0.2"
                  }
                 }
                },
                "A1": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0"
                  }
                 }
                }
               }
              }
             }
            }
           }
          },
          "R": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "wait",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "time",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "once",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Velocity",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0"
               }
              }
             },
             "A1": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0"
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Drive back (0.2 m/s) for so many seconds, and stand still."
    }
   }
  }
 },
 {
  "name": "turnBetween",
  "block": {
   "type": "define",
   "extraState": {
    "name": "turnBetween",
    "as": "task",
    "arity": 2,
    "equations": [
     {}
    ],
    "signature": "Degrees -> Degrees -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "from"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "to"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">>="
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "randomNumber",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "from",
             "args": 0
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "to",
             "args": 0
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "turn",
          "args": 0
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Turn by a random angle between these two, in degrees: left is positive."
    }
   }
  }
 },
 {
  "name": "goTo",
  "block": {
   "type": "define",
   "extraState": {
    "name": "goTo",
    "as": "task",
    "arity": 2,
    "equations": [
     {}
    ],
    "signature": "Meters -> Meters -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "ahead"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "left"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "task",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "tuple",
         "extraState": {
          "items": 0
         }
        }
       },
       "A1": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "runGoTo",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Position",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "ahead",
                "args": 0
               }
              }
             },
             "A1": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "left",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Drive to a place and stand still within a centimetre of it. The place is in metres from where the program started: ahead of the robot as it stood\nthere, and to its left. The robot turns towards the place and drives straight: it does not go round what stands in the way."
    }
   }
  }
 },
 {
  "name": "runGoTo",
  "block": {
   "type": "define",
   "extraState": {
    "name": "runGoTo",
    "as": "state",
    "arity": 3,
    "equations": [
     {
      "guards": 2,
      "otherwise": true,
      "where": true
     }
    ],
    "signature": "Position -> Pose -> Velocity -> (Velocity, Maybe (Done ()))"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "place"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Pose",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "here"
         }
        }
       },
       "A1": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "facing"
         }
        }
       }
      }
     }
    },
    "P0_2": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Velocity",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "v"
         }
        }
       },
       "A1": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "w"
         }
        }
       }
      }
     }
    },
    "C0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": "<"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "rest",
          "args": 0
         }
        }
       },
       "R": {
        "block": {
         "type": "number",
         "extraState": {
          "value": "0.01"
         }
        }
       }
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 2
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          },
          "A1": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          }
         }
        }
       },
       "I1": {
        "block": {
         "type": "if",
         "inputs": {
          "C": {
           "block": {
            "type": "infix",
            "extraState": {
             "op": "&&"
            },
            "inputs": {
             "L": {
              "block": {
               "type": "infix",
               "extraState": {
                "op": "<"
               },
               "inputs": {
                "L": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "abs",
                   "args": 1
                  },
                  "inputs": {
                   "A0": {
                    "block": {
                     "type": "name",
                     "extraState": {
                      "name": "v",
                      "args": 0
                     }
                    }
                   }
                  }
                 }
                },
                "R": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0.01"
                  }
                 }
                }
               }
              }
             },
             "R": {
              "block": {
               "type": "infix",
               "extraState": {
                "op": "<"
               },
               "inputs": {
                "L": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "abs",
                   "args": 1
                  },
                  "inputs": {
                   "A0": {
                    "block": {
                     "type": "name",
                     "extraState": {
                      "name": "w",
                      "args": 0
                     }
                    }
                   }
                  }
                 }
                },
                "R": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0.02"
                  }
                 }
                }
               }
              }
             }
            }
           }
          },
          "T": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Just",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Done",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "tuple",
                  "extraState": {
                   "items": 0
                  }
                 }
                }
               }
              }
             }
            }
           }
          },
          "F": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Nothing",
             "args": 0
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "C0_1": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "abs",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "deviation",
             "args": 0
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "number",
         "extraState": {
          "value": "0.3"
         }
        }
       }
      }
     }
    },
    "E0_1": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 2
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "approach",
             "args": 4
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.15"
               }
              }
             },
             "A1": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "1.2"
               }
              }
             },
             "A2": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "1.5"
               }
              }
             },
             "A3": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "deviation",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "I1": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Nothing",
          "args": 0
         }
        }
       }
      }
     }
    },
    "O0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 2
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "approach",
             "args": 4
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.05"
               }
              }
             },
             "A1": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.3"
               }
              }
             },
             "A2": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.4"
               }
              }
             },
             "A3": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "rest",
                "args": 0
               }
              }
             }
            }
           }
          },
          "A1": {
           "block": {
            "type": "infix",
            "extraState": {
             "op": "*"
            },
            "inputs": {
             "L": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "2"
               }
              }
             },
             "R": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "deviation",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "I1": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Nothing",
          "args": 0
         }
        }
       }
      }
     }
    },
    "W0": {
     "block": {
      "type": "define_pattern",
      "inputs": {
       "P": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Orientation",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "heading"
            }
           }
          }
         }
        }
       },
       "E0_0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "facing",
          "args": 0
         }
        }
       }
      },
      "next": {
       "block": {
        "type": "define",
        "extraState": {
         "name": "way",
         "as": "plain",
         "arity": 0,
         "equations": [
          {}
         ]
        },
        "inputs": {
         "E0_0": {
          "block": {
           "type": "infix",
           "extraState": {
            "op": "subVec"
           },
           "inputs": {
            "L": {
             "block": {
              "type": "name",
              "extraState": {
               "name": "positionToVec",
               "args": 1
              },
              "inputs": {
               "A0": {
                "block": {
                 "type": "name",
                 "extraState": {
                  "name": "place",
                  "args": 0
                 }
                }
               }
              }
             }
            },
            "R": {
             "block": {
              "type": "name",
              "extraState": {
               "name": "positionToVec",
               "args": 1
              },
              "inputs": {
               "A0": {
                "block": {
                 "type": "name",
                 "extraState": {
                  "name": "here",
                  "args": 0
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        },
        "next": {
         "block": {
          "type": "define",
          "extraState": {
           "name": "rest",
           "as": "plain",
           "arity": 0,
           "equations": [
            {}
           ]
          },
          "inputs": {
           "E0_0": {
            "block": {
             "type": "name",
             "extraState": {
              "name": "magnitudeVec",
              "args": 1
             },
             "inputs": {
              "A0": {
               "block": {
                "type": "name",
                "extraState": {
                 "name": "way",
                 "args": 0
                }
               }
              }
             }
            }
           }
          },
          "next": {
           "block": {
            "type": "define",
            "extraState": {
             "name": "deviation",
             "as": "plain",
             "arity": 0,
             "equations": [
              {}
             ]
            },
            "inputs": {
             "E0_0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "normRadians",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "infix",
                  "extraState": {
                   "op": "-"
                  },
                  "inputs": {
                   "L": {
                    "block": {
                     "type": "name",
                     "extraState": {
                      "name": "angleVec",
                      "args": 1
                     },
                     "inputs": {
                      "A0": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "way",
                         "args": 0
                        }
                       }
                      }
                     }
                    }
                   },
                   "R": {
                    "block": {
                     "type": "name",
                     "extraState": {
                      "name": "heading",
                      "args": 0
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   }
  }
 },
 {
  "name": "curveUntilObstacle",
  "block": {
   "type": "define",
   "extraState": {
    "name": "curveUntilObstacle",
    "as": "task",
    "arity": 1,
    "equations": [
     {
      "where": true
     }
    ],
    "signature": "Degrees -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "turning"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "do",
      "inputs": {
       "S": {
        "block": {
         "type": "step_do",
         "inputs": {
          "X": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "task",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Velocity",
                "args": 2
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0.2"
                  }
                 }
                },
                "A1": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "degreesToRadians",
                   "args": 1
                  },
                  "inputs": {
                   "A0": {
                    "block": {
                     "type": "name",
                     "extraState": {
                      "name": "turning",
                      "args": 0
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             },
             "A1": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "obstacle",
                "args": 0
               }
              }
             }
            }
           }
          }
         },
         "next": {
          "block": {
           "type": "step_do",
           "inputs": {
            "X": {
             "block": {
              "type": "name",
              "extraState": {
               "name": "once",
               "args": 1
              },
              "inputs": {
               "A0": {
                "block": {
                 "type": "construct",
                 "extraState": {
                  "con": "Velocity",
                  "args": 2
                 },
                 "inputs": {
                  "A0": {
                   "block": {
                    "type": "number",
                    "extraState": {
                     "value": "0"
                    }
                   }
                  },
                  "A1": {
                   "block": {
                    "type": "number",
                    "extraState": {
                     "value": "0"
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "W0": {
     "block": {
      "type": "define",
      "extraState": {
       "name": "obstacle",
       "as": "plain",
       "arity": 1,
       "equations": [
        {},
        {},
        {}
       ],
       "signature": "Either Bumper Cliff -> Maybe (Done ())"
      },
      "inputs": {
       "P0_0": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Left",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_construct",
            "extraState": {
             "con": "Bumper",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "pattern_any",
               "extraState": {
                "what": "side"
               }
              }
             },
             "A1": {
              "block": {
               "type": "pattern_choice",
               "extraState": {
                "of": "ButtonStatus",
                "value": "Pressed"
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "E0_0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Just",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Done",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "tuple",
               "extraState": {
                "items": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "P1_0": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Right",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_construct",
            "extraState": {
             "con": "Cliff",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "pattern_any",
               "extraState": {
                "what": "side"
               }
              }
             },
             "A1": {
              "block": {
               "type": "pattern_choice",
               "extraState": {
                "of": "CliffStatus",
                "value": "Hole"
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "E1_0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Just",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Done",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "tuple",
               "extraState": {
                "items": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "P2_0": {
        "block": {
         "type": "pattern_any",
         "extraState": {
          "what": "thing"
         }
        }
       },
       "E2_0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Nothing",
          "args": 0
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Drive (0.2 m/s) and turn by so many degrees a second (left is positive) until a bumper is pressed or a cliff sensor sees a hole, and stand still."
    }
   }
  }
 },
 {
  "name": "randomNumber",
  "block": {
   "type": "define",
   "extraState": {
    "name": "randomNumber",
    "as": "task",
    "arity": 2,
    "equations": [
     {}
    ],
    "signature": "Double -> Double -> Task Double"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "from"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "to"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "task",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "draw",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "from",
             "args": 0
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "to",
             "args": 0
            }
           }
          }
         }
        }
       },
       "A1": {
        "block": {
         "type": "tuple",
         "extraState": {
          "items": 0
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| A random number between these two. The same seed of a run gives the same numbers again (rule R13)."
    }
   }
  }
 },
 {
  "name": "dice",
  "block": {
   "type": "define",
   "extraState": {
    "name": "dice",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": "Int -> Task Int"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "sides"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "task",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "draw",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "1"
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "max",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "1"
               }
              }
             },
             "A1": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "sides",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "A1": {
        "block": {
         "type": "tuple",
         "extraState": {
          "items": 0
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| A random whole number from 1 to this one."
    }
   }
  }
 },
 {
  "name": "draw",
  "block": {
   "type": "define",
   "extraState": {
    "name": "draw",
    "as": "plain",
    "arity": 3,
    "equations": [
     {}
    ],
    "signature": "Random a => a -> a -> StdGen -> Done a"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "from"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "to"
      }
     }
    },
    "P0_2": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "gen"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "construct",
      "extraState": {
       "con": "Done",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "fst",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "randomR",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "tuple",
               "extraState": {
                "items": 2
               },
               "inputs": {
                "I0": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "from",
                   "args": 0
                  }
                 }
                },
                "I1": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "to",
                   "args": 0
                  }
                 }
                }
               }
              }
             },
             "A1": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "gen",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   }
  }
 },
 {
  "name": "eitherOr",
  "block": {
   "type": "define",
   "extraState": {
    "name": "eitherOr",
    "as": "task",
    "arity": 2,
    "equations": [
     {}
    ],
    "signature": "Task a -> Task a -> Task a"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "one"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "other"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">>="
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "dice",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "2"
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "lambda",
         "extraState": {
          "inputs": 1
         },
         "inputs": {
          "P0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "n"
            }
           }
          },
          "B": {
           "block": {
            "type": "if",
            "inputs": {
             "C": {
              "block": {
               "type": "infix",
               "extraState": {
                "op": "=="
               },
               "inputs": {
                "L": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "n",
                   "args": 0
                  }
                 }
                },
                "R": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "1"
                  }
                 }
                }
               }
              }
             },
             "T": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "one",
                "args": 0
               }
              }
             },
             "F": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "other",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| One of the two, by chance: each as likely as the other."
    }
   }
  }
 },
 {
  "name": "blink",
  "block": {
   "type": "define",
   "extraState": {
    "name": "blink",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": "LedColor -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "color"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "do",
      "inputs": {
       "S": {
        "block": {
         "type": "step_do",
         "inputs": {
          "X": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "once",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Led1",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "color",
                   "args": 0
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         },
         "next": {
          "block": {
           "type": "step_wait",
           "inputs": {
            "X": {
             "block": {
              "type": "number",
              "extraState": {
               "value": "0.5"
              }
             }
            }
           },
           "next": {
            "block": {
             "type": "step_do",
             "inputs": {
              "X": {
               "block": {
                "type": "name",
                "extraState": {
                 "name": "once",
                 "args": 1
                },
                "inputs": {
                 "A0": {
                  "block": {
                   "type": "construct",
                   "extraState": {
                    "con": "Led1",
                    "args": 1
                   },
                   "inputs": {
                    "A0": {
                     "block": {
                      "type": "choice",
                      "extraState": {
                       "of": "LedColor",
                       "value": "Black"
                      }
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             },
             "next": {
              "block": {
               "type": "step_wait",
               "inputs": {
                "X": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0.5"
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Half a second of light in the first LED, half a second without."
    }
   }
  }
 },
 {
  "name": "beep",
  "block": {
   "type": "define",
   "extraState": {
    "name": "beep",
    "as": "task",
    "arity": 0,
    "equations": [
     {}
    ],
    "signature": "Task ()"
   },
   "inputs": {
    "E0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">>"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "once",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "choice",
            "extraState": {
             "of": "Sound",
             "value": "ButtonSound"
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "wait",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0.5"
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| A short sound."
    }
   }
  }
 },
 {
  "name": "penDown",
  "block": {
   "type": "define",
   "extraState": {
    "name": "penDown",
    "as": "task",
    "arity": 0,
    "equations": [
     {}
    ],
    "signature": "Task ()"
   },
   "inputs": {
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "once",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "choice",
         "extraState": {
          "of": "Pen",
          "value": "PenDown"
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Lower the pen: from here on the robot draws where it drives."
    }
   }
  }
 },
 {
  "name": "penUp",
  "block": {
   "type": "define",
   "extraState": {
    "name": "penUp",
    "as": "task",
    "arity": 0,
    "equations": [
     {}
    ],
    "signature": "Task ()"
   },
   "inputs": {
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "once",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "choice",
         "extraState": {
          "of": "Pen",
          "value": "PenUp"
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Raise the pen: the robot drives on without drawing."
    }
   }
  }
 },
 {
  "name": "penColor",
  "block": {
   "type": "define",
   "extraState": {
    "name": "penColor",
    "as": "task",
    "arity": 0,
    "equations": [
     {}
    ],
    "signature": "PenColor -> Task ()"
   },
   "inputs": {
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "once",
       "args": 0
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Draw in this colour from here on."
    }
   }
  }
 },
 {
  "name": "penWidth",
  "block": {
   "type": "define",
   "extraState": {
    "name": "penWidth",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": "Centimeters -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "width"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "once",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "PenWidth",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "centimetersToMeters",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "width",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Draw this many centimetres wide from here on."
    }
   }
  }
 }
]
