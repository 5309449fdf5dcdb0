/**
 * The subcommands of {@code ./dfra task}: the goals of robots, and their progress. Entry point:
 * {@link org.dfra.cli.task.TaskCommand}.
 */
@NullMarked
package org.dfra.cli.task;

import org.jspecify.annotations.NullMarked;
