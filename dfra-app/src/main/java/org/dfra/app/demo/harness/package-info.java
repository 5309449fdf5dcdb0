/**
 * What every demonstration stands on: processes that are gone afterwards, hosts, robots, and the
 * voice that tells. Enter at {@link org.dfra.app.demo.harness.DemoRunner}.
 */
@NullMarked
package org.dfra.app.demo.harness;

import org.jspecify.annotations.NullMarked;
