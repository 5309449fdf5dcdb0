/**
 * The demonstrations: each one runs real processes, tells what it does in plain sentences with
 * measured times, and leaves nothing behind. Enter at {@link org.dfra.app.demo.DemoCommand}.
 */
@NullMarked
package org.dfra.app.demo;

import org.jspecify.annotations.NullMarked;
