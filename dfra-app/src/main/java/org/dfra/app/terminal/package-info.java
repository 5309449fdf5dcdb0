/**
 * What a command says: tables and paragraphs for people, JSON for programs, and the status it ends
 * with.
 */
@NullMarked
package org.dfra.app.terminal;

import org.jspecify.annotations.NullMarked;
