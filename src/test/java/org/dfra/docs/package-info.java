/**
 * What holds of the documents: links lead somewhere, files and classes that are named exist,
 * commands are commands, and references list what there is.
 *
 * <p>Enter at {@link org.dfra.docs.LinksTest}, {@link org.dfra.docs.CommandsTest} and {@link
 * org.dfra.docs.ModuleConfigurationReferenceTest}; phoenix's own reference is held by a test beside
 * its sources.
 */
package org.dfra.docs;
