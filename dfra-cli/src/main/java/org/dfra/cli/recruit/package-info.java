/**
 * The subcommands of {@code ./dfra recruit}: the status of recruitment. Entry point: {@link
 * org.dfra.cli.recruit.RecruitCommand}.
 */
@NullMarked
package org.dfra.cli.recruit;

import org.jspecify.annotations.NullMarked;
