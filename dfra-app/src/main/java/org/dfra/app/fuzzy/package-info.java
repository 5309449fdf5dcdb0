/**
 * The verbs of {@code ./dfra fuzzy}: what a fuzzy system reads, knows and commands, in one picture.
 */
@NullMarked
package org.dfra.app.fuzzy;

import org.jspecify.annotations.NullMarked;
