/**
 * The directory: finds modules by their capabilities.
 *
 * <pre>
 *   ModuleQuery --&gt; ModuleDirectory --&gt; ModuleListing: proxy, attributes, staleness, locality
 *                        |--listen----&gt; DirectoryListener: matched, changed, unmatched
 *                        |--personas--&gt; Persona: a robot and its modules
 *                        +--proxyFor--&gt; a proxy that fails over among equal modules
 * </pre>
 *
 * <p>Start at {@link org.dfra.directory.ModuleDirectory}. No network type appears here: the same
 * code runs on one robot without a network and on a team of them.
 */
@NullMarked
package org.dfra.directory;

import org.jspecify.annotations.NullMarked;
