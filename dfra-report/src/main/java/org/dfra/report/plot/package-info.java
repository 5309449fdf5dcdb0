/**
 * Plots: panels with time series, paths and heat maps, combined on pages and in reports. Entry
 * points: {@link org.dfra.report.plot.Page}, and {@link org.dfra.report.plot.HtmlReport} for text
 * around pages.
 *
 * <pre>
 *  Series --&gt; LinePanel   values over time or another quantity -+
 *         --&gt; PathPanel   places, equal axes                   -+--&gt; Page --&gt; SVG
 *                                        any other Panel       -+      |
 *                                                                      +--&gt; HtmlReport --&gt; HTML
 * </pre>
 *
 * The same input gives the same bytes if the same fonts are installed. This package needs no
 * display.
 */
@NullMarked
package org.dfra.report.plot;

import org.jspecify.annotations.NullMarked;
