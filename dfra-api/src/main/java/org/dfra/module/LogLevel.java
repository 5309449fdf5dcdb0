package org.dfra.module;

/** How much a module writes to its log; each level includes those after it. */
public enum LogLevel {
  TRACE,
  DEBUG,
  INFO,
  WARN,
  ERROR
}
