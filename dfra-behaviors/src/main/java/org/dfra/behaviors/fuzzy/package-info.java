/**
 * Fuzzy inference, compatible with the MATLAB Fuzzy Logic Toolbox: Mamdani and Sugeno systems, read
 * from {@code .fis} files.
 *
 * <pre>
 *  .fis --FisReader--&gt; FuzzySystem --&gt; Inference: inputs -&gt; memberships -&gt; firing strengths
 *                          |                          -&gt; implied and aggregated sets -&gt; outputs
 *                      FisWriter --&gt; .fis
 * </pre>
 */
@NullMarked
package org.dfra.behaviors.fuzzy;

import org.jspecify.annotations.NullMarked;
