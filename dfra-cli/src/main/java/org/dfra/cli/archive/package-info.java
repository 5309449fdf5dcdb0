/**
 * The shared class archive, with which a command starts in less time.
 *
 * <pre>
 *   ./dfra build, bin/dfra up --&gt; java -XX:ArchiveClassesAtExit=… {@link
 *   org.dfra.cli.archive.ArchivedClasses} --&gt; lib/archive/JAVA.jsa
 *   every command --&gt; java -XX:SharedArchiveFile=… {@link org.dfra.cli.Main}
 * </pre>
 *
 * <p>See decision 052.
 */
@NullMarked
package org.dfra.cli.archive;

import org.jspecify.annotations.NullMarked;
