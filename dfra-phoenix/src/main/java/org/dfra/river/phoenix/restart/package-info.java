/**
 * When a group is restarted whose process has exited: at once, after a delay, or not before a
 * hold-off is over.
 *
 * <p>Enter at {@link org.dfra.river.phoenix.restart.RestartPolicy}.
 */
@NullMarked
package org.dfra.river.phoenix.restart;

import org.jspecify.annotations.NullMarked;
