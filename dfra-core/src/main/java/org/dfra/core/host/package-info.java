/**
 * What the host gives to those who start programs on it: ports that stay free until they are taken,
 * and files and folders that other users cannot reach.
 */
@NullMarked
package org.dfra.core.host;

import org.jspecify.annotations.NullMarked;
