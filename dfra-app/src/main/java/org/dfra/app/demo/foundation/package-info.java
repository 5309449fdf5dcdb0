/** {@code ./dfra demo foundation}: a receiver found by what it can do, and back after kill -9. */
@NullMarked
package org.dfra.app.demo.foundation;

import org.jspecify.annotations.NullMarked;
