/**
 * The verbs of {@code ./dfra task}: what robots are told to do, and how far they are. Enter at
 * {@link org.dfra.app.task.TaskCommand}.
 */
@NullMarked
package org.dfra.app.task;

import org.jspecify.annotations.NullMarked;
