/**
 * The subcommands of {@code ./dfra task}: the goals of robots, and their progress. Entry point:
 * {@link org.dfra.app.task.TaskCommand}.
 */
@NullMarked
package org.dfra.app.task;

import org.jspecify.annotations.NullMarked;
