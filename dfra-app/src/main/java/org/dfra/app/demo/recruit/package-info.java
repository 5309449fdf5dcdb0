/**
 * {@code ./dfra demo recruit}: robots ask each other for help and give it. Bodies of all robots
 * live in one virtual machine, each with its own lookup service; each robot's agent is an activated
 * module in a process of its own. Enter at {@link org.dfra.app.demo.recruit.RecruitDemo}.
 */
@NullMarked
package org.dfra.app.demo.recruit;

import org.jspecify.annotations.NullMarked;
