/** {@code ./dfra demo foundation}: finds a receiver by capability, and recovers after kill -9. */
@NullMarked
package org.dfra.examples.foundation;

import org.jspecify.annotations.NullMarked;
