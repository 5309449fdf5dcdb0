/** {@code ./dfra demo persona}: modules found by what they can do, kept through failures. */
@NullMarked
package org.dfra.app.demo.persona;

import org.jspecify.annotations.NullMarked;
