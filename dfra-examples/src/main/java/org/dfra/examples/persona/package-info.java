/** {@code ./dfra demo persona}: modules found by capability and kept through failures. */
@NullMarked
package org.dfra.examples.persona;

import org.jspecify.annotations.NullMarked;
