/**
 * The common base of all demonstrations: the environment, which ends its processes, hosts, robots,
 * and the progress reports. Entry point: {@link org.dfra.examples.harness.DemoRunner}.
 */
@NullMarked
package org.dfra.examples.harness;

import org.jspecify.annotations.NullMarked;
