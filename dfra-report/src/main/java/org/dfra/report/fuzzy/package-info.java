/**
 * The subcommands of {@code ./dfra fuzzy}: the inputs, rules and outputs of a fuzzy system, in one
 * image.
 */
@NullMarked
package org.dfra.report.fuzzy;

import org.jspecify.annotations.NullMarked;
