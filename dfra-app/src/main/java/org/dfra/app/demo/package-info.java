/**
 * The demonstrations: each one runs real processes, reports its steps in plain sentences with
 * measured times, and cleans up everything it started. Entry point: {@link
 * org.dfra.app.demo.DemoCommand}.
 */
@NullMarked
package org.dfra.app.demo;

import org.jspecify.annotations.NullMarked;
