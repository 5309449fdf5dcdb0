/**
 * Host resources: free TCP ports for servers, files and folders that other users cannot access, and
 * the name of the command that is installed here.
 */
@NullMarked
package org.dfra.core.host;

import org.jspecify.annotations.NullMarked;
