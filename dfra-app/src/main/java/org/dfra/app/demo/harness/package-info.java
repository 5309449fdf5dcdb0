/**
 * The common base of all demonstrations: the environment, which ends its processes, hosts, robots,
 * and the progress reports. Entry point: {@link org.dfra.app.demo.harness.DemoRunner}.
 */
@NullMarked
package org.dfra.app.demo.harness;

import org.jspecify.annotations.NullMarked;
