/** The guard in front of effectors, and what halts wheels. */
@NullMarked
package org.dfra.core.effector;

import org.jspecify.annotations.NullMarked;
