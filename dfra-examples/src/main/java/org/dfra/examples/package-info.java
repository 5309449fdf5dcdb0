/**
 * The demonstrations: each one runs real processes, reports its steps in plain sentences with
 * measured times, and cleans up everything it started. Entry point: {@link
 * org.dfra.examples.DemoCommand}.
 */
@NullMarked
package org.dfra.examples;

import org.jspecify.annotations.NullMarked;
