/**
 * Plots: panels with time series, paths and heat maps, put together on pages and in reports. Enter
 * at {@link org.dfra.app.plot.Page}, or at {@link org.dfra.app.plot.HtmlReport} for text around
 * pages.
 *
 * <pre>
 *  Series --&gt; LinePanel   values over time or another quantity -+
 *         --&gt; PathPanel   places, equal axes                   -+--&gt; Page --&gt; SVG
 *                                        any other Panel       -+      |
 *                                                                      +--&gt; HtmlReport --&gt; HTML
 * </pre>
 *
 * The same input gives the same bytes where the same fonts are installed. Nothing here needs a
 * display.
 */
@NullMarked
package org.dfra.app.plot;

import org.jspecify.annotations.NullMarked;
