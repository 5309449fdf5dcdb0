/**
 * What holds of the house itself: both builds agree and are handed what {@code ./dfra test} is
 * asked, arrows point one way, the repository holds sources only.
 *
 * <p>Enter at {@link org.dfra.build.BuildParityTest}, {@link org.dfra.build.TestVerbTest}, {@link
 * org.dfra.build.ArchitectureTest} and {@link org.dfra.build.RepositoryTest}.
 */
package org.dfra.build;
