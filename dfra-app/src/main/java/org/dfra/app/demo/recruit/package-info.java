/**
 * {@code ./dfra demo recruit}: robots request and give help. All modules of all robots run in one
 * JVM, each robot with its own lookup service; each robot's agent is an activated module in a
 * separate process. Entry point: {@link org.dfra.app.demo.recruit.RecruitDemo}.
 */
@NullMarked
package org.dfra.app.demo.recruit;

import org.jspecify.annotations.NullMarked;
