/**
 * What a process of phoenix, the daemon or a group's virtual machine, has of its computer: the lock
 * that it holds until it exits, and files for its output.
 *
 * <p>Enter at {@link org.dfra.river.phoenix.host.ProcessLock}.
 */
@NullMarked
package org.dfra.river.phoenix.host;

import org.jspecify.annotations.NullMarked;
