/** The benchmarks' own parts, held to what they are to do rather than to a figure. */
package org.dfra.benchmarks;
