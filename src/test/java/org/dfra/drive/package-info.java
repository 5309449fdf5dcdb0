/** A robot's wheels: found, commanded and halted across processes. */
@NullMarked
package org.dfra.drive;

import org.jspecify.annotations.NullMarked;
