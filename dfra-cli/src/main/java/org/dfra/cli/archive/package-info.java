/**
 * The archives of classes, with which commands and robots' processes start in less time.
 *
 * <pre>
 *   ./dfra build, or dfra up in the background --&gt; {@link org.dfra.cli.archive.ArchiveWriter}
 *     --&gt; java -XX:ArchiveClassesAtExit=… {@link org.dfra.cli.archive.ArchivedClasses}
 *         --&gt; JAVA.jsa, for {@link org.dfra.cli.Main}
 *     --&gt; {@link org.dfra.cli.archive.ArchivedProcesses}, and a group of its robot
 *         --&gt; robot-JAVA-CHECKSUM.jsa or .aot, for phoenix and groups
 * </pre>
 *
 * <p>See decisions 052 and 058.
 */
@NullMarked
package org.dfra.cli.archive;

import org.jspecify.annotations.NullMarked;
