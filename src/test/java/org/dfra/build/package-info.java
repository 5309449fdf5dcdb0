/**
 * What holds of the house itself: both builds agree, arrows point one way, the repository holds
 * sources only.
 *
 * <p>Enter at {@link org.dfra.build.BuildParityTest}, {@link org.dfra.build.ArchitectureTest} and
 * {@link org.dfra.build.RepositoryTest}.
 */
package org.dfra.build;
