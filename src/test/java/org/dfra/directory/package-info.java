/**
 * One suite for every directory: what {@link org.dfra.directory.DirectoryContract} asks, the
 * directory in memory and the one over lookup services answer alike.
 */
package org.dfra.directory;
