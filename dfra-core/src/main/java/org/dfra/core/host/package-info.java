/**
 * Host resources: free TCP ports for servers, and files and folders that other users cannot access.
 */
@NullMarked
package org.dfra.core.host;

import org.jspecify.annotations.NullMarked;
