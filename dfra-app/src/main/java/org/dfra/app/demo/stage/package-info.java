/**
 * What every demonstration stands on: processes that are gone afterwards, hosts, robots, and the
 * voice that tells. Enter at {@link org.dfra.app.demo.stage.Performance}.
 */
@NullMarked
package org.dfra.app.demo.stage;

import org.jspecify.annotations.NullMarked;
