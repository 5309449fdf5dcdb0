/**
 * The output of a command: tables and paragraphs as text, JSON for programs, and the exit status.
 */
@NullMarked
package org.dfra.report.terminal;

import org.jspecify.annotations.NullMarked;
