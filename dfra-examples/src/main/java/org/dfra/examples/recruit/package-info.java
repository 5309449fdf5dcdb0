/**
 * {@code ./dfra demo recruit}: robots request and give help. All modules of all robots run in one
 * JVM, each robot with its own lookup service; each robot's agent is an activated module in a
 * separate process. Entry point: {@link org.dfra.examples.recruit.RecruitDemo}.
 */
@NullMarked
package org.dfra.examples.recruit;

import org.jspecify.annotations.NullMarked;
