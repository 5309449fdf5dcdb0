/**
 * Benchmarks of single operations by JMH, the Java Microbenchmark Harness of OpenJDK: a remote
 * call, marshalling, a step of the fuzzy controller, the receivers' parsers, and the search of a
 * camera's image. {@code ./dfra bench micro} runs those of {@link
 * org.dfra.benchmarks.micro.MicroBenchmark#ALL}, some beside the same operation of plain Java. What
 * needs several threads, processes or seconds is measured by {@code org.dfra.benchmarks} itself.
 */
@NullMarked
package org.dfra.benchmarks.micro;

import org.jspecify.annotations.NullMarked;
